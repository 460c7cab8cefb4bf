0 BEGIN PGM F277 INCH
1 ; = kind end of the program missing in inches
2 BLK FORM 0.1 Z X+0 Y+0 Z-.75
3 BLK FORM 0.2 X+4 Y+3 Z+0
4 TOOL DEF 2 L+0 R+.25
5 TOOL CALL 2 Z S2500
6 L Z+2 R0 FMAX M3
7 L X-.5 Y+1 FMAX
8 L Z-.1 F100
9 L X+4.5 F80
10 L Z+2 FMAX ; = fault
