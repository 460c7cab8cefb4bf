/PROG  PICK_PART
/ATTR
OWNER		= MNEDITOR;
COMMENT		= "PICK";
PROG_SIZE	= 412;
DEFAULT_GROUP	= 1,*,*,*,*;
/MN
   1:  UFRAME_NUM=1 ;
   2:  UTOOL_NUM=2 ;
   3:J P[1] 100% FINE    ;
   4:L P[2] 250mm/sec CNT50    ;
   5:  RO[1]=ON ;
   6:  WAIT    .50(sec) ;
   7:L P[1] 500mm/sec FINE    ;
/POS
P[1]{
   GP1:
	UF : 1, UT : 2,		CONFIG : 'N U T, 0, 0, 0',
	X =   420.000  mm,	Y =   -35.000  mm,	Z =   210.000  mm,
	W =   180.000 deg,	P =     0.000 deg,	R =    90.000 deg
};
/END
