//! Numbers with a meaning: parameters of cycles, M functions, FN functions.

/// The parameters of cycles (TNC 640 cycle programming 34059x).
const PARAMETERS: &[(u32, &str)] = &[
    (200, "set-up clearance: above the surface, incremental"),
    (201, "depth: from the surface, incremental; negative is down"),
    (202, "plunging depth: of one infeed"),
    (203, "surface coordinate: absolute"),
    (204, "2nd set-up clearance: above the surface, incremental"),
    (205, "min. plunging depth"),
    (206, "feed rate for plunging"),
    (207, "feed rate for milling"),
    (208, "retraction feed rate: 0 is that of plunging"),
    (210, "dwell time at top, s"),
    (211, "dwell time at depth, s"),
    (212, "decrement: by which each infeed is less than the one before"),
    (213, "number of chip breaks before a full retraction"),
    (214, "disengaging direction: 0 none, 1 -a, 2 -b, 3 +a, 4 +b"),
    (215, "machining operation: 0 both, 1 roughing, 2 finishing"),
    (216, "center in 1st axis"),
    (217, "center in 2nd axis"),
    (218, "first side length"),
    (219, "second side length, or slot width"),
    (220, "corner radius"),
    (223, "circle diameter"),
    (224, "angle of rotation, degrees"),
    (225, "starting point 1st axis"),
    (226, "starting point 2nd axis"),
    (237, "spacing in 1st axis"),
    (238, "spacing in 2nd axis"),
    (239, "thread pitch: negative is a left-hand thread"),
    (241, "number of operations"),
    (242, "number of columns"),
    (243, "number of lines"),
    (244, "pitch circle diameter"),
    (245, "starting angle, degrees"),
    (246, "stopping angle, degrees"),
    (247, "stepping angle, degrees: 0 divides the angle from start to stop"),
    (248, "angular length, degrees"),
    (249, "depth of counterbore"),
    (250, "material thickness"),
    (251, "off-center distance of the tool"),
    (252, "tool edge height"),
    (253, "feed rate for pre-positioning"),
    (254, "feed rate for counterboring"),
    (255, "dwell time in the counterbore, s"),
    (256, "retraction for chip breaking"),
    (257, "depth for chip breaking"),
    (258, "upper advanced stop distance"),
    (259, "lower advanced stop distance"),
    (301, "move to clearance: 0 at the set-up clearance, 1 at the second"),
    (334, "plunging depth: of one turn"),
    (335, "nominal diameter"),
    (336, "angle of spindle, degrees"),
    (338, "infeed for finishing: 0 in one infeed"),
    (339, "preset number"),
    (342, "roughing diameter: 0 drills from the solid"),
    (343, "select diameter or depth: 0 depth, 1 diameter"),
    (344, "diameter of the centring"),
    (351, "type of milling: +1 climb, -1 up-cut"),
    (365, "type of traverse: 0 straight, 1 on the circle"),
    (366, "plunging: 0 vertical, 1 helical, 2 reciprocating"),
    (367, "position of the shape to the tool"),
    (368, "finishing allowance for side"),
    (369, "finishing allowance for floor"),
    (370, "path overlap: by which the tool radius is multiplied"),
    (374, "angle of rotation of the slot, degrees"),
    (375, "pitch circle diameter of the slot"),
    (376, "starting angle of the slot, degrees"),
    (377, "number of operations of the slot"),
    (378, "stepping angle of the slot, degrees"),
    (379, "starting point for drilling"),
    (385, "feed rate for finishing"),
    (395, "reference for depth: 0 tip, 1 full diameter"),
    (403, "rpm factor for retraction"),
];

/// M functions that are carried out or noted.
const MACHINE_FUNCTIONS: &[(u32, &str)] = &[
    (0, "program stop"),
    (1, "optional stop"),
    (2, "end of program"),
    (3, "spindle on, clockwise"),
    (4, "spindle on, counter-clockwise"),
    (5, "spindle stop"),
    (6, "tool change"),
    (8, "coolant on"),
    (9, "coolant off"),
    (13, "spindle on, clockwise, with coolant"),
    (14, "spindle on, counter-clockwise, with coolant"),
    (30, "end of program, back to its start"),
    (89, "runs the cycle after each block that moves"),
    (91, "coordinates of this block are those of the machine"),
    (92, "coordinates of this block refer to the machine builder's point"),
    (97, "passes this outside corner without an arc"),
    (98, "works this open corner completely"),
    (99, "runs the cycle at the end of this block"),
    (126, "rotary axes take the short way"),
    (127, "rotary axes no longer take the short way"),
    (128, "the tip stays on its path while rotary axes turn (TCPM)"),
    (129, "ends M128"),
    (136, "F in mm per revolution"),
    (137, "F in mm per minute"),
    (140, "retracts along the tool axis by MB"),
];

/// FN functions.
const NUMBERED_FUNCTIONS: &[(u32, &str)] = &[
    (0, "sets a parameter"),
    (1, "adds"),
    (2, "subtracts"),
    (3, "multiplies"),
    (4, "divides"),
    (5, "square root"),
    (6, "sine of an angle in degrees"),
    (7, "cosine of an angle in degrees"),
    (8, "root of the sum of two squares"),
    (9, "jumps to a label if both are equal"),
    (10, "jumps to a label if both are not equal"),
    (11, "jumps to a label if the first is greater"),
    (12, "jumps to a label if the first is less"),
    (13, "angle of two sides, 0 to 360 degrees"),
    (14, "stops with an error message"),
    (15, "prints"),
    (16, "prints in a form"),
    (18, "reads a value of the system"),
    (19, "passes values to the PLC"),
];

fn of(table: &[(u32, &'static str)], number: u32) -> Option<&'static str> {
    table.iter().find(|(own, _)| *own == number).map(|(_, meaning)| *meaning)
}

/// What a parameter of a cycle is.
pub fn parameter_meaning(number: u32) -> Option<&'static str> {
    of(PARAMETERS, number)
}

/// What an M function does.
pub fn machine_function_meaning(number: u32) -> Option<&'static str> {
    of(MACHINE_FUNCTIONS, number)
}

/// What an FN function does.
pub fn numbered_function_meaning(number: u32) -> Option<&'static str> {
    of(NUMBERED_FUNCTIONS, number)
}
