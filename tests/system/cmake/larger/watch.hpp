#pragma once

/// Steps two behaviours. How many events they told of.
int watch();
