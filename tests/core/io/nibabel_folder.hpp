// A temporary folder for files that nibabel reads and writes, if it is installed.
#pragma once

#include <cstdlib>
#include <string>

#include "core/temporary_folder.hpp"

namespace talweg::test {

class NibabelFolder : public TemporaryFolder {
 protected:
  /// Runs lines of Python in the folder, after importing numpy, nibabel and nibabel.freesurfer as
  /// fs.
  bool python(const std::string& script) {
    write("script.py", "import numpy, nibabel, nibabel.freesurfer as fs\n" + script);
    return std::system(
               ("cd '" + file("").string() + "' && /usr/bin/python3 script.py > out.txt 2> err.txt")
                   .c_str()) == 0;
  }
  bool has_nibabel() { return python(""); }
};

constexpr const char* kNoNibabel = "skipped: there is no nibabel (Debian: python3-nibabel)";

}  // namespace talweg::test
