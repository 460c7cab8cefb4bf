%91 G71 *
; = clean
N10 G30 G17 X+0 Y+0 Z-20*
N20 G31 G90 X+100 Y+80 Z+0*
N30 G99 T8 L+0 R+6*
N40 T8 G17 S3000*
N50 G00 G40 G90 Z+100 M3* ; = Z+100
N60 X-20 Y+40* ; = X-20 Y+40 Z+100
N70 Z-5* ; = X-20 Y+40 Z-5
N80 G01 G41 X+5 Y+40 F350* ; = path X-1 Y+40
N90 Y+75*
N100 G25 R12* ; = centre X+17 Y+63 ; = path X-1 Y+63 ; = path X+17 Y+81
N110 X+80* ; = path X+80 Y+81 ; = path X+85.145 Y+78.087
N120 X+95 Y+50* ; = path X+100.145 Y+53.087 ; = path X+101 Y+50
N130 Y+5*
N140 G24 R10* ; = path X+101 Y+15 ; = path X+99.243 Y+10.757 ; = path X+89.243 Y+0.757 ; = path X+85 Y-1
N150 X+5* ; = path X+5 Y-1 ; = path X-1 Y+5
N160 Y+40* ; = path X-1 Y+40
N170 G40 X-20 F900* ; = X-20 Y+40 Z-5
N180 G00 Z+100* ; = X-20 Y+40 Z+100
N190 X+50 Y+40* ; = X+50 Y+40 Z+100
N200 Z+2* ; = X+50 Y+40 Z+2
N210 G01 Z-3 F120* ; = X+50 Y+40 Z-3
N220 G42 X+50 Y+60 F300* ; = path X+50 Y+54
N230 X+75* ; = path X+69 Y+54
N240 Y+20*
N250 G25 R8* ; = centre X+67 Y+28 ; = path X+69 Y+28 ; = path X+67 Y+26
N260 X+25* ; = path X+31 Y+26
N270 Y+60* ; = path X+31 Y+54
N280 X+50* ; = path X+50 Y+54
N290 G40 Y+40* ; = X+50 Y+40 Z-3
N300 G00 Z+100 M30* ; = end X+50 Y+40 Z+100
N99999999 %91 G71 *
