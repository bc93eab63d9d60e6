// Files of the page are bytes. They lie in the memory's file system only while the library reads or
// writes them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace talweg::browser {

/// A file with these bytes, as long as `use` runs. The name's folders are left out: sentences name
/// the file as the page does.
void with_file(const std::string& name, std::string_view bytes,
               const std::function<void(const std::string& path)>& use);

/// The bytes that `write` has written to the path.
std::vector<std::uint8_t> written(const std::string& name,
                                  const std::function<void(const std::string& path)>& write);

}  // namespace talweg::browser
