0 BEGIN PGM VERSCHL MM
1 ; = clean
2 BLK FORM 0.1 Z X-50 Y-40 Z-20
3 BLK FORM 0.2 X+50 Y+40 Z+0
4 TOOL DEF 8 L+0 R+5
5 * - Aussenkontur
6 TOOL CALL 8 Z S5500 DR-0.1
7 L Z+60 R0 FMAX M3 ; = Z+60
8 L X-70 Y+0 R0 FMAX M8 ; = X-70 Y+0 Z+60
9 L Z+2 FMAX ; = X-70 Y+0 Z+2
10 L Z-6 F800 ; = X-70 Y+0 Z-6
11 APPR LCT X-45 Y+0 R6 RL F700 ; = path X-58.453 Y-5.43 ; = path X-49.9 Y+0 ; = centre X-55.9 Y+0
12 L Y+25
13 RND R10 ; = centre X-35 Y+15 ; = path X-49.9 Y+15 ; = path X-35 Y+29.9
14 L X+20 ; = path X+20 Y+29.9 ; = path X+22.521 Y+29.202
15 L X+45 Y+10 ; = path X+47.521 Y+14.202 ; = path X+49.9 Y+10
16 L Y-25
17 CHF 8 ; = path X+49.9 Y-17 ; = path X+48.465 Y-20.465 ; = path X+40.465 Y-28.465 ; = path X+37 Y-29.9
18 L X-45 ; = path X-45 Y-29.9 ; = path X-49.9 Y-25
19 L Y+0 ; = path X-49.9 Y+0
20 DEP LCT X-70 Y+0 R6 F1500 ; = path X-58.453 Y+5.43 ; = X-70 Y+0 Z-6 ; = centre X-55.9 Y+0
21 L Z+60 FMAX ; = X-70 Y+0 Z+60
22 * - Innenkontur
23 L X+0 Y+0 R0 FMAX ; = X+0 Y+0 Z+60
24 L Z+2 FMAX ; = X+0 Y+0 Z+2
25 L Z-4 F250 ; = X+0 Y+0 Z-4
26 APPR CT X+0 Y-18 CCA90 R+7 RL F600 ; = path X-7 Y-6.1 ; = path X+0 Y-13.1 ; = centre X+0 Y-6.1
27 L X+22
28 RND R9 ; = centre X+13 Y-9 ; = path X+13 Y-13.1 ; = path X+17.1 Y-9
29 L Y+12
30 RND R7 ; = centre X+15 Y+5 ; = path X+17.1 Y+5 ; = path X+15 Y+7.1
31 L X-22
32 RND R9 ; = centre X-13 Y+3 ; = path X-13 Y+7.1 ; = path X-17.1 Y+3
33 L Y-18
34 RND R7 ; = centre X-15 Y-11 ; = path X-17.1 Y-11 ; = path X-15 Y-13.1
35 L X+0 ; = path X+0 Y-13.1
36 DEP CT CCA90 R+7 ; = X+7 Y-6.1 Z-4 ; = centre X+0 Y-6.1
37 L X+0 Y+0 R0 F1500 ; = X+0 Y+0 Z-4
38 L Z+60 FMAX M9 ; = X+0 Y+0 Z+60
39 M30 ; = end X+0 Y+0 Z+60
40 END PGM VERSCHL MM
