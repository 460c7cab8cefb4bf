0 BEGIN PGM PALETTE MM
1 ; = clean
2 ; 3 x 2 pieces, one subprogram, shifts counted by parameters
3 FN 0: Q50 = +45 ;PITCH X ; = Q50=+45
4 FN 0: Q51 = +38 ;PITCH Y ; = Q51=+38
5 FN 0: Q52 = +3  ;COLUMNS ; = Q52=+3
6 FN 0: Q53 = +2  ;ROWS ; = Q53=+2
7 BLK FORM 0.1 Z X-20 Y-20 Z-15
8 BLK FORM 0.2 X+120 Y+70 Z+0
9 TOOL CALL 5 Z S4200 F500
10 L Z+50 R0 FMAX M3 ; = Z+50
11 FN 0: Q61 = +0 ; = Q61=+0
12 LBL 1
13 FN 0: Q60 = +0 ; = Q60=+0
14 LBL 2
15 FN 3: Q62 = +Q60 * +Q50 ; = Q62=+90
16 FN 3: Q63 = +Q61 * +Q51 ; = Q63=+38
17 CYCL DEF 7.0 DATUM SHIFT
18 CYCL DEF 7.1 X+Q62
19 CYCL DEF 7.2 Y+Q63
20 CALL LBL 10
21 FN 1: Q60 = +Q60 + +1 ; = Q60=+3
22 FN 12: IF +Q60 LT +Q52 GOTO LBL 2
23 FN 1: Q61 = +Q61 + +1 ; = Q61=+2
24 FN 12: IF +Q61 LT +Q53 GOTO LBL 1
25 CYCL DEF 7.0 DATUM SHIFT
26 CYCL DEF 7.1 X+0
27 CYCL DEF 7.2 Y+0
28 L X+0 Y+0 R0 FMAX ; = X+0 Y+0 Z+50 ; = work X+0 Y+0 Z+50
29 M30 ; = end X+0 Y+0 Z+50
30 LBL 10
31 L X-10 Y+0 R0 FMAX ; = X-10 Y+0 Z+50 ; = work X+80 Y+38 Z+50 ; = runs 6
32 L Z+2 FMAX ; = X-10 Y+0 Z+2 ; = work X+80 Y+38 Z+2 ; = runs 6
33 L Z-1.5 F150 ; = X-10 Y+0 Z-1.5 ; = work X+80 Y+38 Z-1.5 ; = runs 6
34 L X+10 FAUTO ; = X+10 Y+0 Z-1.5 ; = work X+100 Y+38 Z-1.5 ; = runs 6
35 CC X+0 Y+0
36 C X+10 Y+0 DR+ ; = X+10 Y+0 Z-1.5 ; = work X+100 Y+38 Z-1.5 ; = centre X+0 Y+0 ; = runs 6
37 L Z+50 FMAX ; = X+10 Y+0 Z+50 ; = work X+100 Y+38 Z+50 ; = runs 6
38 LBL 0
39 END PGM PALETTE MM
