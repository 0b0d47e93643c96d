# SPDX-License-Identifier: BSD-3-Clause
"""Each unit of the core has its own tests, and they are built."""
from tree import CORE, ROOT

TESTS_OF_CORE = ROOT / "tests" / "core"
# Units of the core whose tests bear another name, and why.
TESTED_AS = {
    "look/look": "corridor_test, depth_test and scan_test ask it and passthrough() the same",
    "look/passthrough": "the same: it is what look() is held against",
    "look/kernel/scan_simd": "look/scan_test and depth_test, in every instruction set, with Highway and without",
    "memory/kernel/lines_simd": "memory/lines_test and connected_test, in every instruction set",
    "memory/kernel/points_simd": "memory/points_test, in every instruction set",
    "guard/caps": "guard/zone_caps_test, horizon_test and masked_lasers_test: each of the caps",
    "guard/settings": "guard/guard_settings_test",
    "guard/directions": "guard_control_test and guarded_drives_test: what is open for a robot that is stuck",
    "guard_memory_known": "guard_memory_test: another part of the same class",
    "guard/given_under_way": "guard/given_test and slowing_test: another part of the same class",
    "guard/out_of_sight_around": "guard/out_of_sight_test: another part of the same class",
    "guard/silhouette": "guard/guard_settings_test and perception_test: what asks it",
    "guard/seen_at": "guard/forgetting_test and out_of_sight_test: what asks it",
    "guard/lost_spots": "guard/known_places_alone_test; and known_places_test: what becomes of a robot by them",
    "guard_sensor": "perception_test: several of them",
    "guard_sensor_known": "perception_test: what several of them let one know",
    "lost_from_sight": "guard/known_places_test and blindness_test: what becomes of a robot by it",
    "memory/column_below": "memory/stand_test: what stands by it",
    "memory/cut_off": "leaving_below_test: where a robot stands for it",
    "memory/step_columns": "low_obstacles_test and strays_on_the_floor_test: what becomes of a step by it",
    "sensor_settings": "guard/guard_settings_test and perception_test",
    "input/kind": "tests/ros/taking_test.cpp: names of what is taken",
    **dict.fromkeys(["guard/cells", "guard/eye", "guard/lists", "guard/new_ground"],
                    "guard_control_test, surroundings_test: what the robot is let do of what several eyes saw"),
    **dict.fromkeys(["memory/following", "memory/losses", "memory/near_ground", "memory/near_pixels",
                     "memory/near_things", "memory/pixels", "memory/raster", "memory/ray_hits", "memory/settings",
                     "memory/things_memory", "memory/written"],
                    "near_loss_test, things_test, together_test: the rules of one memory, of which none shows by itself"),
}


def units_without_a_test(core, tests, others):
    """Sources of the core that have no X_test.cpp where they lie and are no exception; and exceptions that are none."""
    units = {str(file.relative_to(core).with_suffix("")) for file in core.rglob("*.cpp")}
    tested = {str(file.relative_to(tests))[: -len("_test.cpp")] for file in tests.rglob("*_test.cpp")}
    return sorted(units - tested - others), sorted(others & tested | others - units)


def test_every_unit_of_the_core_has_a_test_of_its_own():
    assert units_without_a_test(CORE, TESTS_OF_CORE, set(TESTED_AS)) == ([], [])


def test_every_test_of_the_core_is_built():
    listed = (TESTS_OF_CORE.parent / "CMakeLists.txt").read_text()
    assert [str(file) for file in TESTS_OF_CORE.rglob("*_test.cpp") if f"core/{file.relative_to(TESTS_OF_CORE)}" not in listed] == []


def test_a_unit_without_a_test_is_found(tmp_path):
    for file in ("core/eye.cpp", "core/look/ear.cpp", "core/foot.cpp", "tests/look/ear_test.cpp"):
        (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / file).touch()
    assert units_without_a_test(tmp_path / "core", tmp_path / "tests", {"foot", "look/ear"}) == (["eye"], ["look/ear"])
