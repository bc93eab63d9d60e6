/* The offset of every member, which must never change: on machines with 64-bit pointers. */
#include <stddef.h>

#include "talweg/plugin/talweg_cut_plan.h"
#include "talweg/plugin/talweg_mesh_files.h"
#include "talweg/plugin/talweg_meshes.h"
#include "talweg/plugin/talweg_plugin.h"

#ifdef __cplusplus
#define CHECK(what) static_assert(what, "the layout has changed")
#else
#define CHECK(what) _Static_assert(what, "the layout has changed")
#endif
#define AT(type, member, place) CHECK(offsetof(type, member) == (place))

CHECK(sizeof(void*) == 8);
CHECK(sizeof(talweg_array) == 32);
AT(talweg_array, rows, 8);
AT(talweg_array, stride, 16);
AT(talweg_array, columns, 24);
AT(talweg_array, type, 28);
CHECK(sizeof(talweg_field) == 56);
AT(talweg_field, name, 8);
AT(talweg_field, unit, 16);
AT(talweg_field, values, 24);
CHECK(sizeof(talweg_mesh) == 80);
AT(talweg_mesh, field_count, 4);
AT(talweg_mesh, positions, 8);
AT(talweg_mesh, triangles, 40);
AT(talweg_mesh, fields, 72);
CHECK(sizeof(talweg_curve) == 184);
AT(talweg_curve, closed, 4);
AT(talweg_curve, vertices, 8);
AT(talweg_curve, faces, 40);
AT(talweg_curve, barycentrics, 72);
AT(talweg_curve, positions, 104);
AT(talweg_curve, pins, 136);
AT(talweg_curve, field_count, 168);
AT(talweg_curve, fields, 176);
CHECK(sizeof(talweg_parameter) == 120);
AT(talweg_parameter, id, 16);
AT(talweg_parameter, doc, 40);
AT(talweg_parameter, default_number, 48);
AT(talweg_parameter, soft_maximum, 80);
AT(talweg_parameter, default_choice, 88);
AT(talweg_parameter, choice_count, 96);
AT(talweg_parameter, choices, 104);
AT(talweg_parameter, choice_labels, 112);
CHECK(sizeof(talweg_output) == 40);
AT(talweg_output, name, 8);
AT(talweg_output, doc, 32);
CHECK(sizeof(talweg_report_entry) == 48);
AT(talweg_report_entry, curve, 8);
AT(talweg_report_entry, key, 16);
AT(talweg_report_entry, is_list, 24);
AT(talweg_report_entry, count, 28);
AT(talweg_report_entry, numbers, 32);
AT(talweg_report_entry, texts, 40);
CHECK(sizeof(talweg_sink) == 48);
AT(talweg_sink, context, 8);
AT(talweg_sink, curve, 16);
AT(talweg_sink, mesh, 40);
CHECK(sizeof(talweg_host) == 48);
AT(talweg_host, interface_minor, 8);
AT(talweg_host, name, 16);
AT(talweg_host, context, 32);
AT(talweg_host, get_extension, 40);
CHECK(sizeof(talweg_host_log) == 16);
CHECK(sizeof(talweg_host_progress) == 16);
CHECK(sizeof(talweg_plugin) == 168);
AT(talweg_plugin, id, 8);
AT(talweg_plugin, doc, 32);
AT(talweg_plugin, parameter_count, 40);
AT(talweg_plugin, parameters, 48);
AT(talweg_plugin, create, 64);
AT(talweg_plugin, set_mesh, 80);
AT(talweg_plugin, set_curves, 96);
AT(talweg_plugin, reset, 128);
AT(talweg_plugin, run, 136);
AT(talweg_plugin, last_error, 152);
CHECK(sizeof(talweg_module) == 32);
AT(talweg_module, needs_minor, 12);
AT(talweg_module, plugin_count, 16);
CHECK(sizeof(talweg_attribute) == 96);
AT(talweg_attribute, element, 4);
AT(talweg_attribute, carry, 8);
AT(talweg_attribute, name, 16);
AT(talweg_attribute, fill, 24);
AT(talweg_attribute, values, 32);
AT(talweg_attribute, corners, 64);
CHECK(sizeof(talweg_origin) == 200);
AT(talweg_origin, vertices, 8);
AT(talweg_origin, chains, 168);
CHECK(sizeof(talweg_meshes) == 32);
AT(talweg_meshes, set_attributes, 8);
AT(talweg_meshes, origin, 24);
CHECK(sizeof(talweg_name_list) == 24);
AT(talweg_name_list, attribute, 8);
CHECK(sizeof(talweg_mesh_file) == 96);
AT(talweg_mesh_file, mesh, 8);
AT(talweg_mesh_file, name_list_count, 24);
AT(talweg_mesh_file, references, 40);
AT(talweg_mesh_file, edges, 56);
AT(talweg_mesh_file, frame, 88);
CHECK(sizeof(talweg_mesh_files) == 24);
AT(talweg_mesh_files, read, 8);
CHECK(sizeof(talweg_cut_plan) == 312);
AT(talweg_cut_plan, vertex_count, 8);
AT(talweg_cut_plan, vertices, 24);
AT(talweg_cut_plan, positions, 88);
AT(talweg_cut_plan, parts, 152);
AT(talweg_cut_plan, chains, 280);
CHECK(sizeof(talweg_cut_plans) == 16);
AT(talweg_cut_plans, plan, 8);
