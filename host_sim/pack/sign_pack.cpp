#include "host_sim/pack/sign_pack.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

void sign_with_minisign(const std::string& file, const std::string& secret_key) {
    require_regular_file(secret_key);
    const std::string signature = file + ".minisig";
    const char* const words[] = {"minisign",        "-S",   "-q", "-s", secret_key.c_str(), "-m", file.c_str(), "-x",
                                 signature.c_str(), nullptr};
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_adddup2(&quiet, STDERR_FILENO, STDOUT_FILENO);  // the command's result alone goes to stdout
    pid_t child = 0;
    const int failed = posix_spawnp(&child, words[0], &quiet, nullptr, const_cast<char* const*>(words), environ);
    posix_spawn_file_actions_destroy(&quiet);
    if (failed != 0)
        throw UserError(std::string("minisign cannot be run (") + std::strerror(failed) + "); install the package minisign");
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM))
        throw Interrupted("interrupted; nothing was written");
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw UserError(secret_key + ": minisign does not sign with this key; its own words stand above");
}

}  // namespace tedavis::host_sim
