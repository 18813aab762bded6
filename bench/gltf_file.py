"""Reads a glTF file whole, changes it a little, writes it as one .glb. Plain Python.

The benchmarks put a ground plane beside a model and give plain materials to what has none, so that
Blender and we get the same scene.
"""
import base64
import json
import os
import struct
import urllib.parse

JSON_CHUNK, BIN_CHUNK = 0x4E4F534A, 0x004E4942
FLOAT, UNSIGNED_INT = 5126, 5125
# What Blender's Cycles shows where a mesh has no material: matte, 0.8.
CYCLES_DEFAULT_COLOR = [0.8, 0.8, 0.8]


def diffuse_material(name, color, emission=None):
    """Purely diffuse: without the 4 % dielectric reflection that glTF adds by default."""
    material = {
        "name": name,
        "pbrMetallicRoughness": {"baseColorFactor": list(color) + [1.0], "metallicFactor": 0.0,
                                 "roughnessFactor": 1.0},
        "extensions": {"KHR_materials_specular": {"specularFactor": 0.0}},
    }
    if emission and max(emission) > 0:
        strength = max(1.0, max(emission))
        material["emissiveFactor"] = [e / strength for e in emission]
        material["extensions"]["KHR_materials_emissive_strength"] = {"emissiveStrength": strength}
    return material


class GltfFile:
    """`doc` is the JSON; all buffers and images lie in `blob`."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        self.folder = os.path.dirname(path)
        self.blob = bytearray()
        own = None
        if data[:4] == b"glTF":
            length, = struct.unpack_from("<I", data, 12)
            self.doc = json.loads(data[20:20 + length])
            if 20 + length < len(data):
                size, = struct.unpack_from("<I", data, 20 + length)
                own = data[28 + length:28 + length + size]
        else:
            self.doc = json.loads(data)
        self._merge_buffers(own)
        self._embed_images()

    def _fetch(self, uri):
        if uri.startswith("data:"):
            return base64.b64decode(uri.split(",", 1)[1])
        with open(os.path.join(self.folder, urllib.parse.unquote(uri)), "rb") as file:
            return file.read()

    def _append(self, data):
        self.blob += b"\0" * (-len(self.blob) % 16)
        offset = len(self.blob)
        self.blob += data
        return offset

    def _merge_buffers(self, own):
        starts = [self._append(self._fetch(b["uri"]) if "uri" in b else own)
                  for b in self.doc.get("buffers", [])]
        for view in self.doc.get("bufferViews", []):
            view["byteOffset"] = view.get("byteOffset", 0) + starts[view["buffer"]]
            view["buffer"] = 0

    def _embed_images(self):
        for image in self.doc.get("images", []):
            if "uri" not in image:
                continue
            uri = image.pop("uri")
            image["bufferView"] = self.add_view(self._fetch(uri))
            png = uri.lower().endswith(".png") or uri.startswith("data:image/png")
            image["mimeType"] = "image/png" if png else "image/jpeg"

    def add_view(self, data):
        views = self.doc.setdefault("bufferViews", [])
        views.append({"buffer": 0, "byteOffset": self._append(data), "byteLength": len(data)})
        return len(views) - 1

    def add_accessor(self, values, kind, component):
        letter = "f" if component == FLOAT else "I"
        flat = [c for v in values for c in v] if kind == "VEC3" else list(values)
        accessor = {"bufferView": self.add_view(struct.pack(f"<{len(flat)}{letter}", *flat)),
                    "componentType": component, "count": len(values), "type": kind}
        if kind == "VEC3":
            accessor["min"] = [min(v[i] for v in values) for i in range(3)]
            accessor["max"] = [max(v[i] for v in values) for i in range(3)]
        self.doc.setdefault("accessors", []).append(accessor)
        return len(self.doc["accessors"]) - 1

    def add_material(self, material):
        self.doc.setdefault("materials", []).append(material)
        used = self.doc.setdefault("extensionsUsed", [])
        used += [e for e in material.get("extensions", {}) if e not in used]
        return len(self.doc["materials"]) - 1

    def add_ground(self, centre, half_side, height):
        """A horizontal square, matte, facing up."""
        x, z = centre
        corners = [(x - half_side, height, z - half_side), (x - half_side, height, z + half_side),
                   (x + half_side, height, z + half_side), (x + half_side, height, z - half_side)]
        primitive = {
            "attributes": {"POSITION": self.add_accessor(corners, "VEC3", FLOAT),
                           "NORMAL": self.add_accessor([(0, 1, 0)] * 4, "VEC3", FLOAT)},
            "indices": self.add_accessor([0, 1, 2, 0, 2, 3], "SCALAR", UNSIGNED_INT),
            "material": self.add_material(diffuse_material("ground", CYCLES_DEFAULT_COLOR)),
        }
        self.doc.setdefault("meshes", []).append({"name": "ground", "primitives": [primitive]})
        self.doc["nodes"].append({"name": "ground", "mesh": len(self.doc["meshes"]) - 1})
        self.doc["scenes"][self.doc.get("scene", 0)]["nodes"].append(len(self.doc["nodes"]) - 1)

    def primitives(self):
        return [p for mesh in self.doc["meshes"] for p in mesh["primitives"]]

    def fill_missing_materials(self):
        bare = [p for p in self.primitives() if "material" not in p]
        if bare:
            material = self.add_material(diffuse_material("default", CYCLES_DEFAULT_COLOR))
            for primitive in bare:
                primitive["material"] = material

    def make_diffuse(self, color):
        """One matte material for everything."""
        self.doc["materials"] = []
        material = self.add_material(diffuse_material("matte", color))
        for primitive in self.primitives():
            primitive["material"] = material

    def make_flat(self):
        """Triangles as they are: normals of the vertices are left out."""
        for primitive in self.primitives():
            for name in ("NORMAL", "TANGENT"):
                primitive["attributes"].pop(name, None)

    def write(self, path):
        self.doc["buffers"] = [{"byteLength": len(self.blob)}]
        text = json.dumps(self.doc, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        blob = bytes(self.blob) + b"\0" * (-len(self.blob) % 4)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(blob)))
            file.write(struct.pack("<II", len(text), JSON_CHUNK) + text)
            file.write(struct.pack("<II", len(blob), BIN_CHUNK) + blob)
