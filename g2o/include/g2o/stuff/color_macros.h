// SPDX-License-Identifier: BSD-3-Clause
// Colours of a terminal: CL_RED("text") in a stream.
#pragma once

// Attributes, foreground and background as ANSI escape sequences number them.
#define ATTR_RESET "0"
#define ATTR_BOLD "1"
#define ATTR_DIM "2"
#define ATTR_UNDERSCORE "4"
#define ATTR_BLINK "5"
#define ATTR_REVERSE "7"
#define FG_BLACK "30"
#define FG_RED "31"
#define FG_GREEN "32"
#define FG_YELLOW "33"
#define FG_BLUE "34"
#define FG_MAGENTA "35"
#define FG_CYAN "36"
#define FG_WHITE "37"
#define FG_NORM "39"
#define BG_BLACK "40"
#define BG_RED "41"
#define BG_GREEN "42"
#define BG_YELLOW "43"
#define BG_BLUE "44"
#define BG_MAGENTA "45"
#define BG_CYAN "46"
#define BG_WHITE "47"
#define BG_NORM "49"

#define CL_ESCAPE_(code) "\033[" code "m"
#define CL_IN_(color, s) CL_ESCAPE_(color) << s << CL_ESCAPE_(ATTR_RESET)
#define CL_RED(s) CL_IN_(FG_RED, s)
#define CL_GREEN(s) CL_IN_(FG_GREEN, s)
#define CL_YELLOW(s) CL_IN_(FG_YELLOW, s)
#define CL_BLUE(s) CL_IN_(FG_BLUE, s)
#define CL_MAGENTA(s) CL_IN_(FG_MAGENTA, s)
#define CL_CYAN(s) CL_IN_(FG_CYAN, s)
#define CL_WHITE(s) CL_IN_(FG_WHITE, s)
