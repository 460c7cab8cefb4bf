//! Parameters and expressions of LinuxCNC (RS274/NGC).

use crate::vocabulary::*;

/// LinuxCNC's manual, "Overview": numbered and named parameters, expressions, binary operators, functions.
pub(in crate::controls) static MACROS: MacroRules = MacroRules {
    form: MacroForm::OWords,
    comments_act: true,
    locals: 30,
    common: VARIABLES,
    system: SYSTEM,
    equal_tolerance: 1e-6,
    ..MacroRules::NONE
};

/// Numbers that no system parameter has. Those that the control's parameter file lists are kept while it is off.
const VARIABLES: &[VariableRange] = &[
    volatile(31, 5020),
    volatile(5030, 5060),
    volatile(5071, 5160),
    volatile(5170, 5180),
    volatile(5190, 5209),
    volatile(5391, 5398),
    volatile(5414, 5419),
    volatile(5429, 5601),
];

/// Values of the axes U, V and W, which are not simulated, are what the program writes into them.
const SYSTEM: &[SystemRow] = &[
    system(5021, 5026, SystemVariable::MachinePosition),
    system(5027, 5029, SystemVariable::Output),
    system(5061, 5066, SystemVariable::ProbePosition),
    system(5067, 5069, SystemVariable::Output),
    system(5070, 5070, SystemVariable::ProbeResult),
    system(5161, 5166, SystemVariable::Home),
    system(5167, 5169, SystemVariable::Output),
    system(5181, 5186, SystemVariable::SecondHome),
    system(5187, 5189, SystemVariable::Output),
    system(5210, 5210, SystemVariable::PresetActs),
    system(5211, 5216, SystemVariable::Preset),
    system(5217, 5219, SystemVariable::Output),
    system(5220, 5220, SystemVariable::WorkSystem),
    system(5221, 5390, SystemVariable::WorkTable),
    // The value that M66 has read.
    system(5399, 5399, SystemVariable::NotSimulated),
    system(5400, 5400, SystemVariable::Tool),
    system(5401, 5406, SystemVariable::SpindleTool),
    system(5407, 5409, SystemVariable::Constant(0)),
    system(5410, 5410, SystemVariable::ToolDiameter),
    system(5411, 5413, SystemVariable::Constant(0)),
    system(5420, 5425, SystemVariable::BlockEnd),
    system(5426, 5428, SystemVariable::Constant(0)),
];

/// Named parameters, and expressions that need brackets.
pub(in crate::controls) static GRAMMAR: MacroGrammar = MacroGrammar {
    operators: OPERATORS,
    functions: FUNCTIONS,
    abbreviations: false,
    chained: true,
    names: true,
    operators_in_brackets_only: true,
    bracket_limit: None,
    ..MacroGrammar::MACRO_B
};

/// LinuxCNC's manual, "Overview", binary operators.
const OPERATORS: &[OperatorRow] = &[
    operator("**", Operator::Power, 5),
    operator("*", Operator::Multiply, 4),
    operator("/", Operator::Divide, 4),
    operator("MOD", Operator::Modulo, 4),
    operator("+", Operator::Add, 3),
    operator("-", Operator::Subtract, 3),
    operator("EQ", Operator::Equal, 2),
    operator("NE", Operator::NotEqual, 2),
    operator("GE", Operator::GreaterOrEqual, 2),
    operator("GT", Operator::Greater, 2),
    operator("LE", Operator::LessOrEqual, 2),
    operator("LT", Operator::Less, 2),
    operator("AND", Operator::And, 1),
    operator("XOR", Operator::Xor, 1),
    operator("OR", Operator::Or, 1),
];

const FUNCTIONS: &[(&str, Function)] = &[
    ("SIN", Function::Sin),
    ("COS", Function::Cos),
    ("TAN", Function::Tan),
    ("ASIN", Function::Asin),
    ("ACOS", Function::Acos),
    ("ATAN", Function::Atan),
    ("SQRT", Function::Sqrt),
    ("ABS", Function::Abs),
    ("ROUND", Function::Round),
    ("FIX", Function::Fix),
    ("FUP", Function::Fup),
    ("LN", Function::Ln),
    ("EXP", Function::Exp),
    ("EXISTS", Function::Exists),
];
