+ History: version 1, whole machine with one spindle
POST_NAME = "Small router (mm) (*.nc)"
FILE_EXTENSION = "nc"
UNITS = "MM"
LINE_ENDING = "[13][10]"
LINE_NUMBER_START = 0
var LINE_NUMBER = [N|A|N|1.0]
var SPINDLE_SPEED = [S|A|S|1.0]
var FEED_RATE = [F|C|F|1.1]
var X_POSITION = [X|A|X|1.3]
var Y_POSITION = [Y|A|Y|1.3]
var Z_POSITION = [Z|A|Z|1.3]
begin HEADER
"T[T]M6"
"G17"
"G0[ZH]"
"G0[XH][YH][S]M3"
begin FEED_MOVE
"G1[X][Y][Z][F]"
begin FOOTER
"G0[ZH]"
"M30"
