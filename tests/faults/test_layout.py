# SPDX-License-Identifier: BSD-3-Clause
"""Clouds whose header contradicts their bytes, sent to one robot after another without a restart between them."""
import numpy as np
import pytest
from damaged import cut_short, damaged
from robot import driving_robot
from scenes import POINT_STEP, WIDTH, always, cloud_of, hall, points_of, wall, xyz
from sensor_msgs.msg import PointField

FLOAT32, FLOAT64 = PointField.FLOAT32, PointField.FLOAT64
HUGE = 2**32 - 1
BYTES = cloud_of(points_of()).data


@pytest.fixture(scope="module")
def robot(master):
    with driving_robot() as robot:
        yield robot


CONTRADICTIONS = {
    "no_fields": dict(fields=[]),
    "no_x": dict(fields=xyz()[1:]),
    "two_x": dict(fields=xyz() + xyz()[:1]),
    "float64_x": dict(fields=xyz(x=PointField("x", 0, FLOAT64, 1))),
    "float64_all": dict(fields=[PointField(name, 4 * i, FLOAT64, 1) for i, name in enumerate("xyz")]),
    "datatype_int32": dict(fields=xyz(y=PointField("y", 4, PointField.INT32, 1))),
    "datatype_0": dict(fields=xyz(z=PointField("z", 8, 0, 1))),
    "datatype_255": dict(fields=xyz(z=PointField("z", 8, 255, 1))),
    "count_0": dict(fields=xyz(z=PointField("z", 8, FLOAT32, 0))),
    "count_huge": dict(fields=xyz(z=PointField("z", 8, FLOAT32, HUGE))),
    "offset_near_2_to_the_32": dict(fields=xyz(x=PointField("x", HUGE - 1, FLOAT32, 1))),
    "offset_beyond_the_point": dict(fields=xyz(z=PointField("z", POINT_STEP - 3, FLOAT32, 1))),
    "same_offset": dict(fields=xyz(y=PointField("y", 0, FLOAT32, 1))),
    "point_step_0": dict(point_step=0),
    "point_step_huge": dict(point_step=HUGE),
    "row_step_0": dict(row_step=0),
    "row_step_short_by_one": dict(row_step=POINT_STEP * WIDTH - 1),
    "row_step_huge": dict(row_step=HUGE),
    "width_times_height_is_2_to_the_32": dict(width=2**16, height=2**16),
    "width_times_height_is_beyond": dict(width=HUGE, height=HUGE),
    "width_times_point_step_wraps_to_0": dict(width=2**28, height=1, row_step=0, data=b""),
    "height_times_row_step_wraps_to_0": dict(width=1, height=2**16, row_step=2**16, data=b""),
    "data_short_by_one_byte": dict(data=BYTES[:-1]),
    "data_long_by_one_byte": dict(data=BYTES + b"\0"),
    "no_data": dict(data=b""),
}


@pytest.mark.parametrize("claims", CONTRADICTIONS.values(), ids=CONTRADICTIONS)
def test_a_cloud_that_contradicts_itself_is_unreadable(robot, claims):
    robot.camera.show(always(cloud_of(points_of(), **claims)))
    assert robot.stops("UNREADABLE").reason
    robot.camera.show(hall())
    robot.drives()


def beyond_its_end(whole):
    return whole[:12] + b"\xff\xff\xff\x7f" + whole[16:]  # the length of frame_id


@pytest.mark.parametrize("damage", [cut_short, beyond_its_end])
def test_a_message_that_cannot_be_deserialised_is_unreadable(robot, damage):
    robot.camera.show(always(damaged(cloud_of(points_of()), damage)))
    assert robot.stops("UNREADABLE").reason == "the message ends before its contents"
    robot.camera.show(hall())
    robot.drives()


@pytest.mark.parametrize("claims", [dict(width=0, row_step=0), dict(height=0, row_step=HUGE)], ids=["rows", "columns"])
def test_four_billion_rows_or_columns_of_no_points_are_no_work(robot, claims):
    nothing = dict(width=HUGE, height=HUGE, data=b"")
    robot.camera.show(always(cloud_of(points_of(), **{**nothing, **claims})))
    robot.stops("BLIND" if claims.get("width") == 0 else "UNREADABLE")
    robot.camera.show(hall())
    robot.drives()


def test_big_endian_clouds_are_read_as_such(robot):
    def big_endian(*boards):
        swapped = np.frombuffer(cloud_of(points_of(*boards)).data, np.float32).byteswap()
        return always(cloud_of(points_of(), is_bigendian=True, data=swapped.tobytes()))

    robot.camera.show(big_endian(wall(0.45)))
    assert abs(robot.stops("SEEN").nearest - 0.45) < 1e-6
    robot.camera.show(big_endian())
    robot.drives()


def test_little_endian_clouds_that_claim_to_be_big_endian_stop_the_robot(robot):
    robot.camera.show(always(cloud_of(points_of(), is_bigendian=True)))
    robot.stops("WRONG_VIEW")  # its points lie along no camera's rays
    robot.camera.show(hall(wall(3.0)))
    robot.drives()


def test_float64_clouds_are_read_as_such(robot):
    def wide(*boards):
        points = points_of(*boards).astype(np.float64)
        fields = [PointField(name, 8 * i, FLOAT64, 1) for i, name in enumerate("xyz")]
        return always(cloud_of(points_of(), fields=fields, point_step=24, row_step=24 * WIDTH, data=points.tobytes()))

    robot.camera.show(wide(wall(0.45)))
    assert abs(robot.stops("SEEN").nearest - 0.45) < 1e-6
    robot.camera.show(wide())
    robot.drives()
