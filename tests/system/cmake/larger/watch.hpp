#pragma once

/// Steps two behaviours. Returns the number of their events.
int watch();
