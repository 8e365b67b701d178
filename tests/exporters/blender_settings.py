"""All properties of Blender 5.0 that may change a render, and what a capture does with each.

A capture sets those of `rna_export.blender.rna_renders.render_settings.OWNED`. The others are
here: a property that is in neither is new, and has to be decided on.
"""

SET_FOR_EACH_RENDER = {
    "Scene": "camera world",
    "RenderSettings": "resolution_x resolution_y threads filepath",
    "CyclesRenderSettings": "samples seed pixel_filter_type filter_width sample_clamp_direct "
    "sample_clamp_indirect denoiser",
    "ViewLayer": "use_pass_normal use_pass_diffuse_direct use_pass_diffuse_color "
    "use_pass_glossy_direct use_pass_glossy_color use_pass_transmission_direct "
    "use_pass_transmission_color",
}

TAKEN_APART = {  # by source_scene, camera_visibility, object_materials, render_only
    "Scene": "view_layers",
    "ViewLayer": "material_override aovs layer_collection",
    "LayerCollection": "holdout indirect_only hide_viewport",
    "Object": "visible_camera is_holdout is_shadow_catcher hide_viewport "
    "show_instancer_for_viewport",
    "Material": "displacement_method",
}

OF_THE_ASSET = {  # its shape and its look, as the file renders them
    "Scene": "background_set objects frame_current frame_subframe frame_float "
    "frame_current_final collection rigidbody_world gravity use_gravity",
    "RenderSettings": "frame_map_old frame_map_new fps fps_base use_simplify "
    "simplify_subdivision simplify_child_particles simplify_subdivision_render "
    "simplify_child_particles_render simplify_volumes",
    "CyclesRenderSettings": "shading_system caustics_reflective caustics_refractive blur_glossy "
    "max_bounces diffuse_bounces glossy_bounces transmission_bounces volume_bounces "
    "volume_step_rate volume_max_steps volume_biased",
    "ViewLayer": "objects active_layer_collection",
    "LayerCollection": "collection children exclude is_visible",
    "Object": "data type parent parent_type parent_vertices parent_bone "
    "use_parent_final_indices track_axis up_axis material_slots location rotation_quaternion "
    "rotation_axis_angle rotation_euler rotation_mode scale dimensions delta_location "
    "delta_rotation_euler delta_rotation_quaternion delta_scale matrix_world matrix_local "
    "matrix_basis matrix_parent_inverse modifiers shader_effects constraints vertex_groups "
    "add_rest_position_attribute pass_index color field collision soft_body particle_systems "
    "rigid_body rigid_body_constraint use_simulation_cache hide_render "
    "show_instancer_for_render visible_diffuse visible_glossy visible_transmission "
    "visible_volume_scatter visible_shadow instance_type use_instance_vertices_rotation "
    "use_instance_faces_scale instance_faces_scale instance_collection is_instancer pose "
    "show_only_shape_key active_shape_key active_shape_key_index is_from_instancer is_from_set "
    "shadow_terminator_normal_offset shadow_terminator_geometry_offset "
    "shadow_terminator_shading_offset light_linking cycles",
    "CyclesObjectSettings": "shadow_terminator_offset shadow_terminator_geometry_offset",
    "Material": "node_tree use_nodes use_transparent_shadow pass_index diffuse_color "
    "specular_color roughness specular_intensity metallic max_vertex_displacement cycles",
    "CyclesMaterialSettings": "use_bump_map_correction volume_sampling volume_interpolation "
    "volume_step_rate",
}

HARMLESS = {  # of viewports, other engines, display, films, or of what is off
    "Scene": "frame_start frame_end frame_step time_jump_unit time_jump_delta "
    "lock_frame_selection_to_range use_preview_range frame_preview_start frame_preview_end "
    "show_subframe show_keys_from_selected_only use_stamp_note is_nla_tweakmode "
    "use_custom_simulation_range simulation_frame_start simulation_frame_end sync_mode "
    "compositing_node_group use_nodes sequence_editor keying_sets keying_sets_all tool_settings "
    "unit_settings render safe_areas timeline_markers transform_orientation_slots cursor "
    "use_audio use_audio_scrub audio_doppler_speed audio_doppler_factor audio_distance_model "
    "audio_volume annotation active_clip view_settings display_settings "
    "sequencer_colorspace_settings display eevee grease_pencil_settings hydra cycles "
    "cycles_curves animation_data",
    "RenderSettings": "image_settings preview_pixel_size ppm_factor ppm_base ffmpeg "
    "dither_intensity filter_size motion_blur_shutter motion_blur_position "
    "motion_blur_shutter_curve hair_type hair_subdiv use_high_quality_normals border_min_x "
    "border_min_y border_max_x border_max_y file_extension is_movie_format use_lock_interface "
    "use_stamp_time use_stamp_date use_stamp_frame use_stamp_frame_range use_stamp_camera "
    "use_stamp_lens use_stamp_scene use_stamp_note use_stamp_marker use_stamp_filename "
    "use_stamp_sequencer_strip use_stamp_render_time stamp_note_text use_stamp_labels "
    "metadata_input use_stamp_memory use_stamp_hostname stamp_font_size stamp_foreground "
    "stamp_background sequencer_gl_preview use_sequencer_override_scene_strip views "
    "stereo_views views_format has_multiple_engines use_spherical_stereo use_simplify_normals "
    "simplify_gpencil simplify_gpencil_onplay simplify_gpencil_antialiasing "
    "simplify_gpencil_view_fill simplify_gpencil_modifier simplify_gpencil_shader_fx "
    "simplify_gpencil_tint line_thickness_mode line_thickness bake compositor_device "
    "compositor_precision compositor_denoise_device compositor_denoise_preview_quality "
    "compositor_denoise_final_quality",
    "ImageFormatSettings": "quality compression use_jpeg2k_ycc use_jpeg2k_cinema_preset "
    "use_jpeg2k_cinema_48 jpeg2k_codec tiff_codec use_cineon_log cineon_black cineon_white "
    "cineon_gamma stereo_3d_format view_settings display_settings linear_colorspace_settings "
    "has_linear_colorspace",
    "CyclesRenderSettings": "preview_pause denoising_prefilter denoising_quality "
    "denoising_input_passes denoising_use_gpu use_preview_denoising preview_denoiser "
    "preview_denoising_prefilter preview_denoising_quality preview_denoising_input_passes "
    "preview_denoising_start_sample preview_denoising_use_gpu preview_samples "
    "sample_subset_length preview_scrambling_distance adaptive_threshold adaptive_min_samples "
    "use_preview_adaptive_sampling preview_adaptive_threshold preview_adaptive_min_samples "
    "min_light_bounces min_transparent_bounces use_deterministic_guiding "
    "guiding_distribution_type guiding_directional_sampling_type use_surface_guiding "
    "surface_guiding_probability use_volume_guiding guiding_training_samples "
    "volume_guiding_probability use_guiding_direct_light use_guiding_mis_weights "
    "guiding_roughness_threshold volume_preview_step_rate dicing_rate preview_dicing_rate "
    "max_subdivisions dicing_camera offscreen_dicing_scale film_transparent_roughness "
    "debug_bvh_time_steps bake_type camera_cull_margin distance_cull_margin "
    "rolling_shutter_duration texture_limit fast_gi_method ao_bounces ao_bounces_render "
    "use_auto_tile tile_size debug_use_cpu_avx2 debug_use_cpu_sse42 "
    "debug_use_cuda_adaptive_compile debug_use_optix_debug debug_use_hip_adaptive_compile "
    "debug_use_metal_adaptive_compile",
    "CyclesCurveRenderSettings": "subdivisions",
    "ViewLayer": "eevee active_aov active_aov_index lightgroups active_lightgroup "
    "active_lightgroup_index pass_cryptomatte_depth use_pass_cryptomatte_accurate "
    "use_motion_blur has_export_collections use_freestyle freestyle_settings depsgraph cycles",
    "Object": "mode bound_box use_camera_lock_parent active_material active_material_index "
    "lock_location lock_rotation lock_rotation_w lock_rotations_4d lock_scale "
    "empty_display_type empty_display_size empty_image_offset image_user empty_image_depth "
    "show_empty_image_perspective show_empty_image_orthographic "
    "show_empty_image_only_axis_aligned use_empty_image_alpha empty_image_side hide_select "
    "hide_probe_volume hide_probe_sphere hide_probe_plane hide_surface_pick display_type "
    "show_bounds display_bounds_type show_name show_axis show_texture_space show_wire "
    "show_all_edges use_grease_pencil_lights show_transparent show_in_front "
    "use_shape_key_edit_mode use_dynamic_topology_sculpting display lineart use_mesh_mirror_x "
    "use_mesh_mirror_y use_mesh_mirror_z lightgroup animation_data animation_visualization "
    "motion_path selection_sets active_selection_set",
    "CyclesObjectSettings": "use_motion_blur use_deform_motion motion_steps use_camera_cull "
    "use_distance_cull ao_distance is_caustics_caster is_caustics_receiver",
    "Material": "surface_render_method blend_method alpha_threshold use_transparency_overlap "
    "show_transparent_back use_backface_culling use_backface_culling_shadow "
    "use_backface_culling_lightprobe_volume use_raytrace_refraction use_screen_refraction "
    "use_sss_translucency refraction_depth thickness_mode use_thickness_from_shadow "
    "volume_intersection_method preview_render_type use_preview_world animation_data "
    "texture_paint_images texture_paint_slots paint_active_slot paint_clone_slot line_color "
    "line_priority grease_pencil is_grease_pencil lineart",
    "CyclesMaterialSettings": "emission_sampling",
    "ColorManagedViewSettings": "look view_transform exposure gamma curve_mapping "
    "use_curve_mapping use_white_balance white_balance_temperature white_balance_tint "
    "white_balance_whitepoint is_hdr support_emulation",
    "ColorManagedDisplaySettings": "display_device emulation",
}


def known(kind: str) -> set[str]:
    """Properties of a type that are listed here."""
    lists = SET_FOR_EACH_RENDER, TAKEN_APART, OF_THE_ASSET, HARMLESS
    return {name for each in lists for name in each.get(kind, "").split()}
