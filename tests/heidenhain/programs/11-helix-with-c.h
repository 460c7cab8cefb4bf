0 BEGIN PGM RAMPE MM
1 ; = clean
2 BLK FORM 0.1 Z X-50 Y-50 Z-10
3 BLK FORM 0.2 X+50 Y+50 Z+0
4 TOOL CALL 11 Z S6000
5 L Z+25 R0 FMAX M3
6 L X+20 Y+0 R0 FMAX ; = X+20 Y+0
7 L Z+1 FMAX ; = X+20 Y+0 Z+1
8 CC X+0 Y+0
9 C X+20 Y+0 Z-1 DR+ F400 ; = X+20 Y+0 Z-1 ; = centre X+0 Y+0
10 C X+20 Y+0 IZ-2 DR+ ; = X+20 Y+0 Z-3 ; = centre X+0 Y+0
11 C X-20 Y+0 Z-3.5 DR+ ; = X-20 Y+0 Z-3.5 ; = centre X+0 Y+0
12 C Y+20 X+0 DR- ; = X+0 Y+20 Z-3.5 ; = centre X+0 Y+0
13 CR X+20 Y+0 R+20 DR- ; = X+20 Y+0 Z-3.5 ; = centre X+0 Y+0
14 L Z+25 FMAX ; = X+20 Y+0 Z+25
15 M30 ; = end X+20 Y+0 Z+25
16 END PGM RAMPE MM
