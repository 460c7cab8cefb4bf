0 BEGIN PGM KONTUR_2X MM
1 ; = clean
2 BLK FORM 0.1 Z X-32 Y-22 Z-14
3 BLK FORM 0.2 X+32 Y+22 Z+0
4 CYCL DEF 32.0 TOLERANZ
5 CYCL DEF 32.1 T0.01
6 CYCL DEF 32.2 HSC-MODE:1 TA0.1
7 ; T5 D=8 CR=0 - Schaftfraeser
8 TOOL CALL 5 Z S6000
9 L Z+40 R0 FMAX M3 ; = Z+40
10 QL1 = 0 ; = QL1=+0
11 LBL 10
12 QL1 = QL1 - 3.5 ; = QL1=-10.5 ; = runs 3
13 L X+0 Y-40 FMAX ; = X+0 Y-40 Z+5 ; = runs 3
14 CALL LBL 20
15 FN 11: IF +QL1 GT -10 GOTO LBL 10
16 FN 9: IF +0 EQU +0 GOTO LBL 30
17 LBL 20
18 L Z+QL1 F800 ; = X+0 Y-40 Z-10.5 ; = runs 3
19 L Y-26 F900 ; = X+0 Y-26 Z-10.5 ; = runs 3
20 L X-28 ; = X-28 Y-26 Z-10.5 ; = runs 3
21 CR X-36 Y-18 R8 DR- ; = X-36 Y-18 Z-10.5 ; = centre X-28 Y-18 ; = runs 3
22 L Y+18 ; = X-36 Y+18 Z-10.5 ; = runs 3
23 CR X-28 Y+26 R8 DR- ; = X-28 Y+26 Z-10.5 ; = centre X-28 Y+18 ; = runs 3
24 L X+28 ; = X+28 Y+26 Z-10.5 ; = runs 3
25 CR X+36 Y+18 R8 DR- ; = X+36 Y+18 Z-10.5 ; = centre X+28 Y+18 ; = runs 3
26 L Y-18 ; = X+36 Y-18 Z-10.5 ; = runs 3
27 CR X+28 Y-26 R8 DR- ; = X+28 Y-26 Z-10.5 ; = centre X+28 Y-18 ; = runs 3
28 L X+0 ; = X+0 Y-26 Z-10.5 ; = runs 3
29 L Y-40 ; = X+0 Y-40 Z-10.5 ; = runs 3
30 L Z+5 FMAX ; = X+0 Y-40 Z+5 ; = runs 3
31 LBL 0
32 LBL 30
33 CYCL DEF 32.0 TOLERANZ
34 CYCL DEF 32.1
35 L Z+40 R0 FMAX ; = X+0 Y-40 Z+40
36 M30 ; = end X+0 Y-40 Z+40
37 END PGM KONTUR_2X MM
