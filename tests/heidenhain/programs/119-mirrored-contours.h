0 BEGIN PGM LINKSRECHTS MM
1 ; = clean
2 BLK FORM 0.1 Z X-60 Y-40 Z-20
3 BLK FORM 0.2 X+60 Y+40 Z+0
4 TOOL DEF 11 L+0 R+3
5 TOOL CALL 11 Z S6000
6 L Z+50 R0 FMAX M3 ; = Z+50
7 CALL LBL 1
8 CYCL DEF 8.0 SPIEGELN
9 CYCL DEF 8.1 X
10 CALL LBL 1
11 CYCL DEF 8.0 SPIEGELN
12 CYCL DEF 8.1
13 CALL LBL 2
14 CYCL DEF 8.0 SPIEGELN
15 CYCL DEF 8.1 X Y
16 CALL LBL 2
17 CYCL DEF 8.0 SPIEGELN
18 CYCL DEF 8.1
19 L X+0 Y+0 R0 FMAX ; = X+0 Y+0 Z+50 ; = work X+0 Y+0 Z+50
20 M30 ; = end X+0 Y+0 Z+50
21 ; inside of a pocket on the right
22 LBL 1
23 L X+30 Y+0 R0 FMAX ; = X+30 Y+0 Z+50 ; = work X-30 Y+0 Z+50 ; = runs 2
24 L Z+1 FMAX ; = X+30 Y+0 Z+1 ; = work X-30 Y+0 Z+1 ; = runs 2
25 L Z-3 F200 ; = X+30 Y+0 Z-3 ; = work X-30 Y+0 Z-3 ; = runs 2
26 APPR CT X+30 Y-12 CCA90 R+5 RL F500 ; = path X+25 Y-4 ; = path X+30 Y-9 ; = centre X+30 Y-4 ; = runs 2
27 L X+45 ; = path X+42 Y-9 ; = runs 2
28 L Y+12 ; = path X+42 Y+9 ; = runs 2
29 L X+15 ; = path X+18 Y+9 ; = runs 2
30 L Y-12 ; = path X+18 Y-9 ; = runs 2
31 L X+30 ; = path X+30 Y-9 ; = runs 2
32 DEP CT CCA90 R+5 ; = X+35 Y-4 Z-3 ; = centre X+30 Y-4 ; = runs 2
33 L X+30 Y+0 R0 ; = X+30 Y+0 Z-3 ; = work X-30 Y+0 Z-3 ; = runs 2
34 L Z+50 FMAX ; = X+30 Y+0 Z+50 ; = work X-30 Y+0 Z+50 ; = runs 2
35 LBL 0
36 LBL 2
37 L X+35 Y-35 R0 FMAX ; = X+35 Y-35 Z+50 ; = work X-35 Y+35 Z+50 ; = runs 2
38 L Z+1 FMAX ; = X+35 Y-35 Z+1 ; = work X-35 Y+35 Z+1 ; = runs 2
39 L Z-1 F200 ; = X+35 Y-35 Z-1 ; = work X-35 Y+35 Z-1 ; = runs 2
40 CC X+35 Y-25
41 C X+45 Y-25 DR+ F400 ; = X+45 Y-25 Z-1 ; = work X-45 Y+25 Z-1 ; = centre X+35 Y-25 ; = runs 2
42 L Y-20 ; = X+45 Y-20 Z-1 ; = work X-45 Y+20 Z-1 ; = runs 2
43 L Z+50 FMAX ; = X+45 Y-20 Z+50 ; = work X-45 Y+20 Z+50 ; = runs 2
44 LBL 0
45 END PGM LINKSRECHTS MM
