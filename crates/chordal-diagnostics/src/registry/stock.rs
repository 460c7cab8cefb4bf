//! Stock: collisions, remaining material, and limits of tools.

use super::codes;

codes! {
    RapidThroughStock = 620, "rapid-through-stock", Error;
    "a rapid moves through material";
    r#"The tool moves at rapid through stock that no cut before has removed. The depth is how far the tool is
inside: at least and at most. Lift the tool before the move, or cut the place first; often a G0 should have been a G1."#;

    DeeperThanFlutes = 621, "deeper-than-flutes", Error;
    "a cut is deeper than the cutting edges are long";
    r#"There is material above the cutting edges (`flute_length` of the tool), so the part of the tool above them rubs.
Cut in more levels, or use a tool with longer edges."#;

    ShankInStock = 622, "shank-in-stock", Error;
    "the shank touches material";
    r#"The shank above the cutting edges (`shank` or `shank_diameter` of the tool) moves into material that is not
removed. Use a longer tool, or remove the material first."#;

    HolderInStock = 623, "holder-in-stock", Error;
    "the holder touches material";
    r#"The holder (`holder` of the tool) moves into material that is not removed. Use a longer tool, or remove the
material first."#;

    FixtureHit = 624, "fixture-hit", Error;
    "the tool or its holder touches a fixture";
    r#"A move goes into a body of `[fixtures]`, or nearer to it than its `clearance`. Lift the tool, move the fixture, or
set the tool deeper in its holder where the holder hits."#;

    CutsWithoutSpindle = 625, "cuts-without-spindle", Error;
    "the tool removes material while the spindle is stopped";
    r#"A feed move goes through material, and the spindle has not been started (M3 or M4) or has been stopped (M5)."#;

    Gouge = 626, "gouge", Error;
    "the cut goes into the part";
    r#"More is removed than the part of `[target]` allows: the cut is deeper than its surface by more than its
`tolerance`."#;

    MaterialLeft = 627, "material-left", Warning;
    "material is left on the part";
    r#"After the program there is more material than the part of `[target]` has, by more than its `tolerance`."#;

    ToolWithoutShape = 628, "tool-without-shape", Warning;
    "a tool cuts whose shape is not known";
    r#"What this tool removes is not known, and nothing is guessed: its moves are not cut from the stock, so nothing
after them is proved. Give its shape with all dimensions in the machine or setup file: `[tools.1] shape`, `diameter` and
what the shape needs, or let the program's comments say it."#;

    NotProved = 629, "stock-not-proved", Warning;
    "a touch can be neither proved nor excluded at this resolution";
    r#"The tool is nearer to the material than the resolution can tell apart. It may touch by the depth that is named.
Use a smaller `--resolution`."#;

    StockNotFollowed = 630, "stock-not-followed", Warning;
    "a move cannot be cut from the stock";
    r#"The place of the tool relative to the part is not known here, the part turns and the tip is not held, or the path is not
followed. The move removes nothing, and nothing after it is proved."#;

    ChipTooThick = 631, "chip-too-thick", Warning;
    "a tooth takes a thicker chip than it may";
    r#"At the feed and speed of this block the thickest chip is above `max_chip` of the tool (or `--chip`). The chip is the
feed of a tooth times how squarely its edge faces the feed; a corner or a full slot makes it thicker at the same F. Lower
F in this block, or let `chordal optimize` do it."#;

    SpindleOverloaded = 632, "spindle-overloaded", Warning;
    "a cut needs more power than the spindle has";
    r#"The power is estimated from the material, the removal rate and the mean chip, and true to about 30 %. It is above
`spindle.power` of the machine. Take less depth, less width, or a lower feed."#;

    ToolRubs = 633, "tool-rubs", Warning;
    "the chip is too thin to be cut";
    r#"The thickest chip of this cut is below `min_chip` of the tool: its edges rub instead of cutting, get hot and wear.
Feed faster, or leave more material for this pass."#;

    AssumedShape = 634, "assumed-shape", Note;
    "the shape or a dimension of a tool was assumed";
    r#"A drill without `point_angle` has the point of a twist drill, 118°. Give the angle in the machine or setup file, or
in the program's comments, if it has another one. A tool that a HEIDENHAIN program defines itself (TOOL DEF with R) and whose
shape no machine file and no comment gives is a cylinder of this radius, with edges as long as L. Give `shape` and its
dimensions in the machine or setup file if it is a ball or bull nose mill or a drill."#;

    GrooveRidge = 640, "groove-ridge", Warning;
    "a ridge is left between two grooving plunges";
    r#"On a lathe: the step between two plunges is larger than the tool is wide, so a ridge stays between them. The message
gives its width and height. Use a smaller step (Q of G75), a wider tool, or enter the true `width` of the tool."#;

    PartOffPip = 641, "part-off-pip", Warning;
    "the part-off leaves a pip";
    r#"On a lathe: a parting tool ends before the part is cut off, or the cut leaves a pip on the part. Feed past the axis
by the corner radius of the tool, or with a bore into the bore."#;

    FlankGouge = 642, "flank-gouge", Error;
    "the flank of the insert cuts into the contour";
    r#"On a lathe: the move goes down more steeply than the insert is free behind its nose, so its flank cuts into a
surface that the program has just made. The message gives the depth. Use an insert with a smaller corner angle, another
holder, or cut this slope from the other side."#;

    NoseGouge = 643, "nose-gouge", Error;
    "without compensation the nose cuts into the programmed contour";
    r#"On a lathe: the programmed point is not on the nose, and without G41 or G42 the nose cuts deeper than the
programmed contour on slopes and arcs that go down. Switch nose radius compensation on, with `nose_radius` and `tip` of
the tool."#;

    NoseLeaves = 644, "nose-leaves", Warning;
    "without compensation the nose leaves material on the contour";
    r#"On a lathe: the nose does not reach the programmed contour on slopes and arcs. On a slope of angle α the radius r
leaves r·(cos α + sin α − 1). Switch nose radius compensation on, with `nose_radius` and `tip` of the tool."#;

    UsualTip = 670, "usual-tip", Note;
    "the tip number of a tool was taken from its holder";
    r#"The machine file gives the designation of a turning holder and no `tip`. The tip number of its usual mounting is taken:
towards the chuck and outside for a right-hand holder, towards the chuck and in a bore for a boring bar, square to the
spindle for a neutral holder. Give `tip` if the tool is mounted in another way. A left-hand holder is as usual in either
direction: for it no number is taken."#;

    ToolContradicted = 671, "tool-contradicted", Warning;
    "two places say different things about a tool";
    r#"The designation of an insert in a comment gives another nose radius than the words next to it, or a comment gives another
nose radius than the machine file. The value of the machine file counts; where a comment contradicts itself, nothing of
its nose radius is taken. Correct the one that is wrong."#;

    StockFromComment = 672, "stock-from-comment", Note;
    "the stock was taken from the program";
    r#"No setup or machine file gives `[stock]`, and the program defines its stock (BLK FORM), or a comment of it says the size of the
stock and where its zero is. The answers about the stock hold for that stock and for no other: a comment may be older than
the program. Give `[stock]` in a setup file to use another one."#;

    StockCommentDoubted = 673, "stock-comment-doubted", Warning;
    "the stock that the program gives does not fit its cuts";
    r#"The stock was taken from the program, and the program removes nothing of it, or cuts far below it (more than three times
its height and 80 mm). Programs are edited and keep the head of an older one: the stock, or its zero, is probably another,
or a depth has a figure too much. Nothing is proved about it. Give `[stock]` in a setup file."#;

    MachineCollision = 680, "machine-collision", Error;
    "two bodies of the machine collide";
    r#"On this move a body of the machine, a fixture, or the tool with its shank and holder touches another body, or comes
nearer to it than the tolerance. The message names both, gives the positions of the axes where they are deepest in each
other, and how deep that is at least. Change the order of the moves, retract farther before the rotary axes turn, or use a
longer tool. If the two bodies may touch, name one in `may_touch` of the other in `[solids]`. Example: a cradle that tilts
into the spindle head."#;

    CollisionNotProved = 681, "collision-not-proved", Warning;
    "it is not proved that nothing collides";
    r#"Something that the check for collisions needs is not known: where an axis is, the points about which rotary axes turn,
what moves a linear axis, the length or the shape of a tool, where a fixture stands. Or the bodies are known to be larger
than the real ones, such as the stock before its first cut, or the check has used up the number of positions that it may
look at. The message says which. Nothing that it names is called free."#;

    NothingToCollide = 682, "nothing-to-collide", Warning;
    "no two bodies are given that could collide";
    r#"The check for collisions compares the bodies of the machine (`[solids]`), the fixtures and the stock of the setup, and the
tools. Here no two of them can move relative to each other, so nothing was compared. Give `[solids]` in the machine file:
the table, the cradle, the spindle head."#;
}
