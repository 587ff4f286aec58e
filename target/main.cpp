// Composition root of the board program.
#include <cstdio>

#include "render_core/base/float_environment.hpp"
#include "target/board_program.hpp"

int main(int count, char** arguments) {
    tedavis::base::set_float_environment();
    return tedavis::target::run_board_program(count - 1, arguments + 1, stdout);
}
