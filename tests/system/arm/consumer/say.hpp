#pragma once

void say(const char* text);
