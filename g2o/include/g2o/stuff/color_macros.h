// SPDX-License-Identifier: BSD-3-Clause
// ANSI escape sequences for terminal colors. `out << CL_RED("text")` colors one text. `out << FG_RED` colors
// all text until FG_NORM is written.
#pragma once
#ifndef G2O_COLOR_MACROS_H
#define G2O_COLOR_MACROS_H

#include <iostream>

#define ATTR_RESET "\033[0m"
#define ATTR_BOLD "\033[1m"
#define ATTR_DIM "\033[2m"
#define ATTR_UNDERSCORE "\033[4m"
#define ATTR_BLINK "\033[5m"
#define ATTR_REVERSE "\033[7m"
#define FT_BOLD ATTR_BOLD
#define FT_UNDERLINE ATTR_UNDERSCORE

// As in g2o, LIGHTBLUE is the ANSI color blue, and BLUE is the ANSI color cyan.
#define FG_BLACK "\033[30m"
#define FG_RED "\033[31m"
#define FG_GREEN "\033[32m"
#define FG_YELLOW "\033[33m"
#define FG_LIGHTBLUE "\033[34m"
#define FG_MAGENTA "\033[35m"
#define FG_BLUE "\033[36m"
#define FG_CYAN FG_BLUE
#define FG_WHITE "\033[37m"
#define FG_NORM ATTR_RESET
#define BG_BLACK "\033[40m"
#define BG_RED "\033[41m"
#define BG_GREEN "\033[42m"
#define BG_YELLOW "\033[43m"
#define BG_LIGHTBLUE "\033[44m"
#define BG_MAGENTA "\033[45m"
#define BG_BLUE "\033[46m"
#define BG_CYAN BG_BLUE
#define BG_WHITE "\033[47m"
#define BG_NORM "\033[49m"

#define CL_BLACK(s) FG_BLACK << s << ATTR_RESET
#define CL_RED(s) FG_RED << s << ATTR_RESET
#define CL_GREEN(s) FG_GREEN << s << ATTR_RESET
#define CL_YELLOW(s) FG_YELLOW << s << ATTR_RESET
#define CL_LIGHTBLUE(s) FG_LIGHTBLUE << s << ATTR_RESET
#define CL_MAGENTA(s) FG_MAGENTA << s << ATTR_RESET
#define CL_BLUE(s) FG_BLUE << s << ATTR_RESET
#define CL_CYAN(s) FG_CYAN << s << ATTR_RESET
#define CL_WHITE(s) FG_WHITE << s << ATTR_RESET

#endif  // G2O_COLOR_MACROS_H
