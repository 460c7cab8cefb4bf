%F172 G71 *
; = kind spindle never started in a program of G codes
N10 G30 G17 X+0 Y+0 Z-20*
N20 G31 G90 X+100 Y+80 Z+0*
N30 T1 G17 S3000*
N40 G00 G40 G90 Z+50*
N50 X-20 Y+20*
N60 G01 Z-3 F500* ; = fault
N70 X+110 F300* ; = fault
N80 G00 G40 G90 Z+50*
N90 M30*
N99999999 %F172 G71 *
