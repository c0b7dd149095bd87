#include <cstdio>
#include <cassert>
#include <cerrno>
#include "main.hpp"
