// A library that is not there when a program needs it.
int RondaTestGone();
int RondaTestGone() { return 0; }
