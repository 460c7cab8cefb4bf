BEGIN PGM KONUS5 MM
; = clean
; pocket with walls of 5 degrees, one ring per depth
Q1 = 0 ; = Q1=+0
Q2 = - 12 ;DEPTH ; = Q2=-12
Q3 = 2 ;STEP ; = Q3=+2
Q4 = 5 ;ANGLE ; = Q4=+5
Q5 = 30 ;HALF LENGTH AT THE TOP ; = Q5=+30
Q6 = 20 ;HALF WIDTH ; = Q6=+20
Q7 = 4 ;TOOL RADIUS ; = Q7=+4
BLK FORM 0.1 Z X-50 Y-40 Z-20
BLK FORM 0.2 X+50 Y+40 Z+0
TOOL DEF 7 L+0 R+4
TOOL CALL 7 Z S5000 F800
L Z+50 R0 FMAX M3 ; = Z+50
L X+0 Y+0 R0 FMAX ; = X+0 Y+0 Z+50
L Z+1 FMAX ; = X+0 Y+0 Z+1
LBL 1
Q1 = Q1 - Q3 ; = Q1=-12
Q10 = Q5 - Q7 + Q1 * TAN Q4 ; = Q10=+24.95
Q11 = Q6 - Q7 + Q1 * TAN Q4 ; = Q11=+14.95
L Z+Q1 F200 ; = X+0 Y+0 Z-12 ; = runs 6
L X+Q10 FAUTO ; = X+24.95 Y+0 Z-12 ; = runs 6
L Y+Q11 ; = X+24.95 Y+14.95 Z-12 ; = runs 6
L X-Q10 ; = X-24.95 Y+14.95 Z-12 ; = runs 6
L Y-Q11 ; = X-24.95 Y-14.95 Z-12 ; = runs 6
L X+Q10 ; = X+24.95 Y-14.95 Z-12 ; = runs 6
L Y+0 ; = X+24.95 Y+0 Z-12 ; = runs 6
L X+0 ; = X+0 Y+0 Z-12 ; = runs 6
FN 11: IF +Q1 GT -11.5 GOTO LBL 1
L Z+50 FMAX ; = X+0 Y+0 Z+50
M2 ; = end X+0 Y+0 Z+50
END PGM KONUS5 MM
