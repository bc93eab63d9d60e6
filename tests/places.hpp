// Where the build that runs a test has its programs and folders. One generated source knows them,
// so that no command line names a folder and compiler caches serve every checkout.
#pragma once

namespace talweg::test {

/// The project's top folder.
const char* source_folder();
/// The plugins of this build.
const char* plugin_folder();
/// The plugins for tests, of tests/plugins/toys.
const char* toy_folder();
/// The program `talweg`, "" where it is not built.
const char* driver_program();
/// The program `talweg-quality`, "" where it is not built.
const char* quality_program();

}  // namespace talweg::test
