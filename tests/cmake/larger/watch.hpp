#pragma once

/// Steps both behaviours once; the number of events that they told of.
int watch();
