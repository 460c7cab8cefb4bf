0 BEGIN PGM ZXBOGEN MM
1 ; = clean
2 ; arcs that stand on edge under tool axis Z
3 BLK FORM 0.1 Z X+0 Y-10 Z-20
4 BLK FORM 0.2 X+60 Y+10 Z+0
5 TOOL CALL 14 Z S5000
6 L Z+30 R0 FMAX M3
7 L X+5 Y+0 R0 FMAX ; = X+5 Y+0
8 L Z+2 FMAX ; = X+5 Y+0 Z+2
9 L Z-4 F300 ; = X+5 Y+0 Z-4
10 L X+20 F500 ; = X+20 Y+0 Z-4
11 CC X+20 Z-5
12 C X+21 Z-5 DR+ ; = X+21 Y+0 Z-5 ; = centre X+20 Z-5
13 L Z-7 ; = X+21 Y+0 Z-7
14 CC X+23 Z-7
15 C X+23 Z-9 DR- ; = X+23 Y+0 Z-9 ; = centre X+23 Z-7
16 L X+40 ; = X+40 Y+0 Z-9
17 L Z+30 FMAX ; = X+40 Y+0 Z+30
18 M30 ; = end X+40 Y+0 Z+30
19 END PGM ZXBOGEN MM
