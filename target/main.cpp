// Composition root of the board program.
#include <cstdio>

#include "target/board_program.hpp"

int main(int count, char** arguments) { return tedavis::target::run_board_program(count - 1, arguments + 1, stdout); }
