#include "lift.hpp"

int main() { return 0; }
