(machine: fadal-4020)
(PRINT and INPUT: the answers come from the machine file.)
(set: macros.inputs = [1.5, 2])
G90 G0 X0 Y0 Z0
#PRINT "DEPTH?" ' (= > "DEPTH?")
#INPUT V1
#INPUT V2
#PRINT "X IS ",V1," Y IS ",V2*2 ' (= > "X IS 1.5 Y IS 4")
#PRINT "ONE ",
#PRINT "LINE ",1/4 ' (= > "ONE LINE 0.25")
#SPRINT V1 ' (= > "1.5")
#PRINT ' (= > "")
#R1=V1
X+R1 (= rapid to X1.5)
#INPUT V3 ' (= ! CH742 "V3" "2 answers")
#WAIT
#V4=V3+1
#PRINT V4 ' (= > "1")
M2
