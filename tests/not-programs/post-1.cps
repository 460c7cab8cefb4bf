/**
  Small mill post, demonstration.
*/
description = "Small mill";
vendor = "Workshop";
extension = "nc";
programNameIsInteger = true;
capabilities = CAPABILITY_MILLING;
var gFormat = createFormat({prefix:"G", decimals:0});
var mFormat = createFormat({prefix:"M", decimals:0});
var xyzFormat = createFormat({decimals:3, forceDecimal:true});
var xOutput = createVariable({prefix:"X"}, xyzFormat);
function onOpen() {
  writeln("%");
  writeln("O" + programName);
  writeBlock(gFormat.format(90), gFormat.format(17)); // G90 G17
}
function onLinear(x, y, z, feed) {
  writeBlock(gFormat.format(1), xOutput.format(x), "F" + feed);
}
function onClose() {
  writeBlock(mFormat.format(30)); // M30
  writeln("%");
}
