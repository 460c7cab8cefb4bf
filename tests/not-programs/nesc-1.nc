#include "Timer.h"
/* Blinks the green lamp twice a second. */
configuration LampAppC {
}
implementation {
  components MainC, LampC, LedsC;
  components new TimerMilliC() as Timer0;

  LampC -> MainC.Boot;
  LampC.Timer0 -> Timer0;
  LampC.Leds -> LedsC;
}
