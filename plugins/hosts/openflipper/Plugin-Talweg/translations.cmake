# Builds the translations into the plugin: sets `translations` to a source file with the translations, or to
# nothing if Qt's tools are missing. A host with Qt 5 does not build the translations of its plugins.
find_program(TALWEG_LRELEASE NAMES lrelease lrelease-qt5 HINTS /usr/lib/qt6/bin /usr/lib/qt5/bin)
find_program(TALWEG_RCC NAMES rcc rcc-qt5 HINTS /usr/lib/qt6/libexec /usr/lib/qt5/bin)
set(translations "")
if(TALWEG_LRELEASE AND TALWEG_RCC)
  set(german ${CMAKE_CURRENT_SOURCE_DIR}/translations/Plugin-Talweg_de_DE.ts)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${german})
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/translations)
  file(WRITE ${folder}/translations.qrc
       "<RCC><qresource prefix=\"/talweg\"><file>Plugin-Talweg_de.qm</file></qresource></RCC>\n")
  execute_process(COMMAND ${TALWEG_LRELEASE} -silent ${german} -qm ${folder}/Plugin-Talweg_de.qm
                  COMMAND_ERROR_IS_FATAL ANY)
  set(translations ${folder}/translations.cpp)
  execute_process(COMMAND ${TALWEG_RCC} --name talweg_translations ${folder}/translations.qrc
                          -o ${translations}
                  COMMAND_ERROR_IS_FATAL ANY)
else()
  message(STATUS "Without lrelease and rcc (qttools5-dev-tools) Plugin-Talweg speaks English only.")
endif()
