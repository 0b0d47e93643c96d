# SPDX-License-Identifier: BSD-3-Clause
"""What a drive is named by; needs Python alone."""
METHODS = ("tutorial", "ours")
FAMILIES = (  # in the order in which episodes are shared out
    *("wall", "wall_in_the_blind_zone", "corner"),
    *("closed_cabinet", "open_cabinet", "post", "post_at_the_edge", "post_in_the_blind_zone", "low_box", "kerb"),
    *("kerb_in_a_lower_corridor", "hanging_board", "table"),
    *("slides_into_the_blind_zone", "slides_out_again", "door_opens", "turned_toward", "turned_onto_a_near_post"),
    *("shelf_slides_in",),
    *("person_crosses", "person_crosses_close", "person_walks_up", "person_walks_up_and_leaves", "person_stands"),
    *("glass_wall", "glass_with_a_frame", "black_wall", "black_box", "black_post_with_a_bright_foot"),
    *("dropouts", "camera_dies", "frozen", "late", "skewed_clock", "speckle", "flying_pixels"),
    *("hall", "hall_with_posts_beside", "doorway", "passage", "bumps"),
)
DRIVERS = {  # whom the guard has before it, and his families
    "rude": ("rude_boxes", "rude_posts", "rude_room", "rude_doorway", "rude_people", "rude_walkers", "rude_mixed"),
    "polite": ("polite_doorway", "polite_posts", "polite_passage"),
}
