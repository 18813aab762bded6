# Renders a glTF file with Blender's Cycles, all surfaces purely diffuse, for bench/agreement.py:
#   blender -b --factory-startup -P bench/cycles_diffuse.py -- SPECIFICATION.json
# The importer's own materials have a reflection that the pictures must not have, so each is
# replaced by a diffuse one (and the glow of the file). Positions in the specification are glTF's:
# (x, y, z) there is (x, -z, y) in Blender.
import json
import math
import sys

import bpy
import numpy
from mathutils import Vector

if not hasattr(numpy, "bool"):
    numpy.bool = bool  # Debian 12: the importer of 3.4.1 uses a name that numpy 1.24 dropped


def from_gltf(v):
    return Vector((v[0], -v[2], v[1]))


def diffuse_nodes(material, color, emission):
    """Diffuse, and on the front only the emission, as glTF has it."""
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*color, 1)
    diffuse.inputs["Roughness"].default_value = 0
    if max(emission) <= 0:
        tree.links.new(diffuse.outputs[0], output.inputs["Surface"])
        return
    glow = tree.nodes.new("ShaderNodeEmission")
    strength = max(emission)
    glow.inputs["Color"].default_value = (*(e / strength for e in emission), 1)
    glow.inputs["Strength"].default_value = strength
    both = tree.nodes.new("ShaderNodeAddShader")
    tree.links.new(diffuse.outputs[0], both.inputs[0])
    tree.links.new(glow.outputs[0], both.inputs[1])
    side = tree.nodes.new("ShaderNodeMixShader")
    geometry = tree.nodes.new("ShaderNodeNewGeometry")
    tree.links.new(geometry.outputs["Backfacing"], side.inputs[0])
    tree.links.new(both.outputs[0], side.inputs[1])
    tree.links.new(diffuse.outputs[0], side.inputs[2])
    tree.links.new(side.outputs[0], output.inputs["Surface"])


def load(spec):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    import addon_utils
    addon_utils.enable("io_scene_gltf2")
    addon_utils.enable("cycles")
    bpy.ops.import_scene.gltf(filepath=spec["gltf"])
    for o in list(bpy.context.scene.objects):
        if o.type in ("CAMERA", "LIGHT"):
            bpy.data.objects.remove(o)
    known = {m["name"]: m for m in spec["materials"]}
    for material in bpy.data.materials:
        if material.users and material.name in known:
            diffuse_nodes(material, known[material.name]["color"], known[material.name]["emission"])
        elif material.users:
            raise KeyError(f"a material that the specification lacks: {material.name}")


def add_camera(scene, spec):
    data = bpy.data.cameras.new("camera")
    camera = bpy.data.objects.new("camera", data)
    scene.collection.objects.link(camera)
    scene.camera = camera
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(spec["vertical_fov"])
    data.clip_start, data.clip_end = 1e-3, 1e6
    position, target = from_gltf(spec["from"]), from_gltf(spec["look_at"])
    camera.location = position
    camera.rotation_euler = (target - position).to_track_quat("-Z", "Y").to_euler()


def add_light(scene, spec):
    world = bpy.data.worlds.new("world")
    scene.world = world
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs[0].default_value = (0, 0, 0, 1)
    if spec["environment"]:
        picture = world.node_tree.nodes.new("ShaderNodeTexEnvironment")
        picture.image = bpy.data.images.load(spec["environment"])
        world.node_tree.links.new(picture.outputs[0], background.inputs[0])
    if spec["sun"]:
        light = bpy.data.lights.new("sun", "SUN")
        light.energy, light.angle = spec["sun"]["watts"], spec["sun"]["angle"]
        sun = bpy.data.objects.new("sun", light)
        sun.rotation_euler = from_gltf(spec["sun"]["travels"]).to_track_quat("-Z", "Y").to_euler()
        scene.collection.objects.link(sun)


def set_up(scene, spec):
    r, c = scene.render, scene.cycles
    r.engine, c.device = "CYCLES", "CPU"
    r.resolution_x, r.resolution_y, r.resolution_percentage = spec["width"], spec["height"], 100
    r.threads_mode, r.threads = "FIXED", spec["threads"]
    r.use_persistent_data = True
    c.samples, c.use_adaptive_sampling, c.use_denoising = spec["samples"], False, False
    c.max_bounces = c.diffuse_bounces = spec["bounces"]
    c.glossy_bounces = c.transmission_bounces = c.volume_bounces = 0
    c.sample_clamp_direct = c.sample_clamp_indirect = 0
    c.light_sampling_threshold = 0
    c.pixel_filter_type, c.filter_width = "BLACKMAN_HARRIS", 1.5
    scene.view_settings.view_transform = "Standard"
    r.image_settings.file_format = "OPEN_EXR"
    r.image_settings.color_depth, r.image_settings.exr_codec = "32", "ZIP"


def main():
    with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as file:
        spec = json.load(file)
    load(spec)
    scene = bpy.context.scene
    add_camera(scene, spec)
    add_light(scene, spec)
    set_up(scene, spec)
    for seed, output in enumerate(spec["outputs"]):
        scene.cycles.seed = seed
        scene.render.filepath = output
        bpy.ops.render.render(write_still=True)
        print("RENDERED", output, flush=True)


main()
