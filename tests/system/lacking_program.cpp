// A program that cannot be loaded: its library is not where the loader looks.
int RondaTestGone();
int main() { return RondaTestGone(); }
