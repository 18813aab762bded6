# data/presets/*.toml as a source file of the library, so that an installed library needs no folder.
# The files stand in the order of their names: one may use the presets of those before it.
file(GLOB preset_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/data/presets/*.toml)
list(SORT preset_files)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${preset_files})
set(preset_rows "")
foreach(file IN LISTS preset_files)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND preset_rows "    {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/presets_data.cpp @ONLY CONTENT
"#include \"io/presets_data.h\"

namespace gp::io {

std::span<const PresetText> presetTexts() {
    static const PresetText texts[] = {
@preset_rows@    };
    return texts;
}

}  // namespace gp::io
")
