// Leaks of libraries that are not ours: Mesa keeps per-context bookkeeping until the process ends, D-Bus (through SDL) too.
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\n"
           "leak:swrast_dri\n"
           "leak:libgallium\n"
           "leak:libLLVM\n"
           "leak:libEGL_mesa\n"
           "leak:libdbus\n";
}
