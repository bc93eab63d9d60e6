// Files of the page are bytes. They are in the file system in memory only while the library reads
// or writes them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace talweg::browser {

/// Makes a file with these bytes while `use` runs. Folders of the name are left out, so that
/// sentences name the file as the page does.
void with_file(const std::string& name, std::string_view bytes,
               const std::function<void(const std::string& path)>& use);

/// The bytes that `write` writes to the path.
std::vector<std::uint8_t> written(const std::string& name,
                                  const std::function<void(const std::string& path)>& write);

}  // namespace talweg::browser
