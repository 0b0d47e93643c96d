# SPDX-License-Identifier: BSD-3-Clause
from pathlib import Path
from typing import Sequence

import numpy as np
import pytest
from recordings import TOPIC, wall_at, write_mcap, write_ros1, write_ros2, write_without_clouds
from sensor_msgs.msg import PointCloud2

from safety_control_cloud.replay import bags
from safety_control_cloud.replay.bags import BagError
from safety_control_cloud.replay.recording import recording

SECOND = 10**9


def read(*bags: Path, topics: Sequence[str] = ()) -> list:
    with recording(bags, topics) as recorded:
        clouds = list(recorded.clouds)
        assert len(clouds) == recorded.count
        return clouds


@pytest.mark.parametrize("write, name", [(write_ros1, "drive.bag"), (write_ros2, "drive"), (write_mcap, "drive")])
def test_clouds_of_every_kind_of_bag_are_what_a_ros1_publisher_would_send(tmp_path, write, name):
    made = [wall_at(1.5, 10 * SECOND + 1), wall_at(0.7, 11 * SECOND)]
    bag = write(tmp_path / name, {TOPIC: made})

    clouds = read(bag)

    assert [cloud.stamp for cloud in clouds] == [10 * SECOND + 1, 11 * SECOND]
    for cloud, original in zip(clouds, made):
        message = PointCloud2().deserialize(cloud.message)
        assert message.header.frame_id == "camera_depth_optical_frame"
        assert (message.width, message.point_step, [field.name for field in message.fields]) == (143, 12, list("xyz"))
        np.testing.assert_array_equal(np.frombuffer(message.data, np.float32).reshape(-1, 3), original.points)


@pytest.mark.parametrize("write", [write_ros2, write_mcap])
def test_a_file_of_a_ros2_bag_is_read_too_or_refused_with_what_to_give(tmp_path, monkeypatch, write):
    (file,) = (one for one in write(tmp_path / "drive", {TOPIC: [wall_at(1.5, 1)]}).iterdir() if one.suffix != ".yaml")

    if bags.OPENS_FILES:
        assert [cloud.stamp for cloud in read(file)] == [1]
    monkeypatch.setattr(bags, "OPENS_FILES", False)
    with pytest.raises(BagError, match=f"{file.name}: .* read by its folder"):
        read(file)


def test_several_bags_are_one_recording_in_the_order_of_time(tmp_path):
    late = write_ros1(tmp_path / "late.bag", {TOPIC: [wall_at(1.0, 30 * SECOND)]})
    early = write_ros1(tmp_path / "early.bag", {TOPIC: [wall_at(1.0, 10 * SECOND), wall_at(1.0, 40 * SECOND)]})

    assert [cloud.stamp // SECOND for cloud in read(late, early)] == [10, 30, 40]


def test_a_topic_is_found_with_or_without_its_slash(tmp_path):
    bag = write_ros1(tmp_path / "two.bag", {"/left": [wall_at(1.0, 1)], "/right": [wall_at(1.0, 2)]})

    assert [cloud.stamp for cloud in read(bag, topics=["right"])] == [2]


def test_several_topics_without_a_choice_are_all_read_and_each_cloud_names_its_own(tmp_path):
    bag = write_ros1(tmp_path / "two.bag", {"/left": [wall_at(1.0, 1), wall_at(1.0, 4)], "/right": [wall_at(1.0, 2), wall_at(1.0, 3)]})

    assert [(cloud.topic, cloud.stamp) for cloud in read(bag)] == [("/left", 1), ("/right", 2), ("/right", 3), ("/left", 4)]


def test_a_topic_that_is_named_twice_is_read_once(tmp_path):
    bag = write_ros1(tmp_path / "drive.bag", {TOPIC: [wall_at(1.0, 1)]})

    assert [cloud.stamp for cloud in read(bag, topics=[TOPIC, TOPIC.strip("/")])] == [1]


def test_the_nodes_own_topic_is_taken_alone_unless_others_are_named(tmp_path):
    bag = write_ros1(tmp_path / "two.bag", {TOPIC: [wall_at(1.0, 1)], "/left": [wall_at(1.0, 2)]})

    assert [cloud.topic for cloud in read(bag)] == [TOPIC]
    assert [cloud.topic for cloud in read(bag, topics=["/left", TOPIC])] == [TOPIC, "/left"]


def test_a_wrong_topic_is_answered_with_those_that_are_there(tmp_path):
    bag = write_ros1(tmp_path / "drive.bag", {TOPIC: [wall_at(1.0, 1)]})

    with pytest.raises(BagError, match=rf"/nowhere in .*drive.bag; there is: {TOPIC} \(1\)$"):
        read(bag, topics=["/nowhere"])


def test_a_bag_without_clouds_is_answered_with_what_it_holds(tmp_path):
    with pytest.raises(BagError, match=r"chatter.bag; there is: /chatter \(std_msgs/String\)$"):
        read(write_without_clouds(tmp_path / "chatter.bag"))


def missing(folder: Path) -> Path:
    return folder / "missing.bag"


def empty(folder: Path) -> Path:
    (folder / "empty.bag").touch()
    return folder / "empty.bag"


def no_bag(folder: Path) -> Path:
    (folder / "text.bag").write_text("not a bag\n" * 100)
    return folder / "text.bag"


def other_suffix(folder: Path) -> Path:
    (folder / "cloud.pcd").write_text("VERSION .7\n")
    return folder / "cloud.pcd"


def empty_folder(folder: Path) -> Path:
    (folder / "drive").mkdir()
    return folder / "drive"


def without_clouds(folder: Path) -> Path:
    return write_without_clouds(folder / "chatter.bag")


def without_messages(folder: Path) -> Path:
    return write_ros1(folder / "quiet.bag", {TOPIC: []})


def ros2_without_database(folder: Path) -> Path:
    bag = write_ros2(folder / "drive", {TOPIC: [wall_at(1.0, 1)]})
    next(bag.glob("*.db3")).unlink()
    return bag


UNUSABLE = (missing, empty, no_bag, other_suffix, empty_folder, without_clouds, without_messages, ros2_without_database)


@pytest.mark.parametrize("make", UNUSABLE)
def test_what_cannot_be_replayed_is_refused_in_one_line_that_names_it(tmp_path, make):
    bag = make(tmp_path)

    with pytest.raises(BagError) as refusal:
        read(bag)

    assert str(bag) in str(refusal.value) and "\n" not in str(refusal.value)


@pytest.mark.parametrize("kept", [1, 13, 14, 100, 4095, 4200, 0.5, 0.9, -1])
def test_a_truncated_bag_is_refused_in_one_line(tmp_path, kept):
    whole = write_ros1(tmp_path / "whole.bag", {TOPIC: [wall_at(1.0, n) for n in range(20)]}).read_bytes()
    cut = tmp_path / "cut.bag"
    cut.write_bytes(whole[: int(kept * len(whole)) if isinstance(kept, float) else kept])

    with pytest.raises(BagError) as refusal:
        read(cut)

    assert str(cut) in str(refusal.value) and "\n" not in str(refusal.value)


def test_no_damaged_byte_brings_anything_but_clouds_or_a_refusal(tmp_path):
    whole = write_ros1(tmp_path / "whole.bag", {TOPIC: [wall_at(1.0, n) for n in range(3)]}).read_bytes()
    damaged = tmp_path / "damaged.bag"
    seed = np.random.SeedSequence().entropy
    print(f"seed {seed}")
    random = np.random.default_rng(seed)
    for _ in range(200):
        content = bytearray(whole)
        content[random.integers(len(content))] ^= 1 << random.integers(8)
        damaged.write_bytes(content)
        try:
            read(damaged)
        except BagError as refusal:
            assert "\n" not in str(refusal)
