#pragma once
// The program includes it. Another file beside the behaviours has the same name.
constexpr int distance = 1;
