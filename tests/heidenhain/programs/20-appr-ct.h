0 BEGIN PGM TASCHE MM
1 ; = clean
2 ; finishing the wall of a pocket that is open already
3 BLK FORM 0.1 Z X+0 Y+0 Z-20
4 BLK FORM 0.2 X+100 Y+100 Z+0
5 TOOL DEF 20 L+0 R+5
6 TOOL CALL 20 Z S4500
7 L Z+100 R0 FMAX M3
8 L X+50 Y+50 R0 FMAX ; = X+50 Y+50 Z+100
9 L Z+2 FMAX ; = X+50 Y+50 Z+2
10 L Z-10 F400 ; = X+50 Y+50 Z-10
11 APPR CT X+50 Y+20 CCA90 R+8 RL F600 ; = path X+42 Y+33 ; = path X+50 Y+25 ; = centre X+50 Y+33
12 L X+90 ; = path X+85 Y+25
13 L Y+80 ; = path X+85 Y+75
14 L X+10 ; = path X+15 Y+75
15 L Y+20 ; = path X+15 Y+25
16 L X+50 ; = path X+50 Y+25
17 DEP CT CCA180 R+8 F1000 ; = X+50 Y+41 Z-10 ; = centre X+50 Y+33
18 L Z+100 R0 FMAX ; = X+50 Y+41 Z+100
19 M30 ; = end X+50 Y+41 Z+100
20 END PGM TASCHE MM
