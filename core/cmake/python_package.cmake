# The contents of python3-talweg: the package, the metadata for importlib and pip, and scripts as dh_python3
# would write: modules are compiled on the machine where they are installed, for its Python.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/plugins/hosts/python/talweg COMPONENT python EXCLUDE_FROM_ALL
        DESTINATION lib/python3/dist-packages  # Debian's Python searches this folder, whatever the prefix
        PATTERN "__pycache__" EXCLUDE)
file(WRITE ${PROJECT_BINARY_DIR}/python/METADATA "Metadata-Version: 2.1
Name: talweg
Version: ${PROJECT_VERSION}
Summary: Smooth curves on triangle meshes while they stay close to what was drawn
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
")
install(FILES ${PROJECT_BINARY_DIR}/python/METADATA COMPONENT python EXCLUDE_FROM_ALL
        DESTINATION lib/python3/dist-packages/talweg-${PROJECT_VERSION}.dist-info)
file(WRITE ${PROJECT_BINARY_DIR}/python/postinst [[
#!/bin/sh
set -e
if [ "$1" = configure ] && command -v py3compile >/dev/null 2>&1; then
  py3compile -p python3-talweg
fi
]])
file(WRITE ${PROJECT_BINARY_DIR}/python/prerm [[
#!/bin/sh
set -e
if command -v py3clean >/dev/null 2>&1; then
  py3clean -p python3-talweg
fi
]])
