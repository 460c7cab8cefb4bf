module LampC {
  uses interface Timer<TMilli> as Timer0;
  uses interface Leds;
  uses interface Boot;
}
implementation {
  uint8_t g1 = 0, x10 = 3;
  event void Boot.booted() {
    call Timer0.startPeriodic(500);
  }
  event void Timer0.fired() {
    g1 = (g1 + 1) % x10;
    call Leds.led1Toggle();
  }
}
