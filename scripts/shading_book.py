"""docs/shading.md from its parts: fragments written by hand (docs/shading), the registry's list of
models and parameters (`glitterpath brdf list --json`), listings found in src/shading, pictures.

In a fragment [[name]] is the listing of a function: a link to the line of its definition.
"""
import json
import os
import re
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PICTURES = "docs/images/shading"

# Headings and fragments of docs/shading/blocks, in the order of the book.
BLOCKS = [("Symbols", "symbols"), ("Frame and conventions", "frame"), ("Fresnel", "fresnel"),
          ("Distributions of normals", "distributions"), ("Masking", "masking"),
          ("Visible normals", "visible_normals"), ("Multiple scattering", "multiple_scattering"),
          ("Thin film", "thin_film"), ("Diffraction", "diffraction")]
GROUPS = [
    ("The renderer's own", ["lambert", "ggx_conductor", "beckmann_conductor", "ggx_dielectric",
                            "thin_dielectric", "sheen", "gltf"]),
    ("Classic", ["half_lambert", "banded", "phong", "modified_phong", "blinn_phong", "minnaert",
                 "oren_nayar", "ward", "ashikhmin_shirley", "lafortune", "stretched_phong",
                 "kelemen", "shirley", "halfway_disk", "kajiya_kay"]),
    ("Microfacet models", ["microfacet", "formula"]),
    ("Disney's models", ["disney", "disney_bsdf"]),
    ("Beyond one bounce and beyond ray optics",
     ["kulla_conty", "iridescent_mirror", "grating", "holzschuch_pacanowski"]),
    ("Below a pixel", ["glint"]),
    ("Measured", ["measured"]),
]


class BookFault(Exception):
    """Something is missing or does not fit; the message says what and where."""


def read(root, path):
    try:
        with open(os.path.join(root, path), encoding="utf-8") as file:
            return file.read()
    except FileNotFoundError:
        raise BookFault(f"{path} is missing") from None


class Listings:
    """Where the functions of src/shading are defined."""

    DEFINITION = re.compile(r"^(?:OUT_OF_LINE )?(?:float|vec2|vec3|vec4|bool|int|uint|[A-Z]\w*) "
                            r"([a-z]\w*)\(", re.M)

    def __init__(self, root):
        self.places = {}
        for folder, _, names in sorted(os.walk(os.path.join(root, "src", "shading"))):
            for name in sorted(names):
                path = os.path.relpath(os.path.join(folder, name), root)
                if name.endswith(".glsl"):
                    self._read(path.replace(os.sep, "/"), read(root, path))

    def _read(self, path, text):
        for found in self.DEFINITION.finditer(text):
            line = text.count("\n", 0, found.start()) + 1
            self.places.setdefault(found.group(1), (path, line))

    def link(self, function):
        if function not in self.places:
            raise BookFault(f"src/shading has no function {function}")
        path, line = self.places[function]
        return f"[`{function}`](../{path}#L{line})"

    def with_links(self, text):
        return re.sub(r"\[\[(\w+)\]\]", lambda found: self.link(found.group(1)), text)


def functions_of_models(root):
    """Name of a model to its eval and its sample function, from models.def."""
    row = re.compile(r"^BSDF_(?:LIBRARY_)?MODEL\(MODEL_\w+, (\w+),\s*(\w+),\s*(\w+),", re.M)
    return {name: (eval_fn, sample_fn) for name, eval_fn, sample_fn
            in row.findall(read(root, "src/shading/bsdf/models.def"))}


def references(root):
    """Key to the entry of docs/references.md."""
    entry = re.compile(r"^- `(\w+)`: (.*(?:\n  .*)*)", re.M)
    return {key: " ".join(text.split()) for key, text
            in entry.findall(read(root, "docs/references.md"))}


def registry(tool):
    return json.loads(subprocess.run([tool, "brdf", "list", "--json"], check=True,
                                     capture_output=True, text=True).stdout)


def number(value):
    return f"{value:.6g}"


def default_of(p):
    value = p["default"]
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        same = len(set(value)) == 1
        return number(value[0]) if same else ", ".join(number(v) for v in value)
    return f"`{value}`" if isinstance(value, str) else number(value)


def range_of(p):
    if "choices" in p:
        return ", ".join(f"`{c}`" for c in p["choices"])
    if p["type"] == "boolean":
        return "true, false"
    beyond = " or beyond" if p.get("mayExceed") else ""
    unit = f" {p['unit']}" if p.get("unit") else ""
    return f"{number(p['minimum'])} to {number(p['maximum'])}{unit}{beyond}"


def parameter_table(model):
    if not model["parameters"]:
        return []
    lines = ["| parameter | type | default | range | |", "|---|---|---|---|---|"]
    for p in model["parameters"]:
        lines.append(f"| `{p['name']}` | {p['type']} | {default_of(p)} | {range_of(p)} "
                     f"| {p['text']} |")
    return lines + [""]


def properties(model):
    words = [word for word in ("reciprocal", "conserving", "transmissive") if model[word]]
    return ", ".join(words or ["neither reciprocal nor conserving for all parameters"]).capitalize()


def pictures_of(root, name):
    """Those that are there: the lit sphere and the slice."""
    tags = []
    for kind, text in (("sphere", "lit sphere"), ("slice", "slice")):
        for ending in ("jpg", "png"):
            path = f"{PICTURES}/{name}-{kind}.{ending}"
            if os.path.exists(os.path.join(root, path)):
                tags.append(f'<img src="{path.removeprefix("docs/")}" alt="{name}: {text}">')
    return [" ".join(tags), ""] if tags else []


def check_equation(equation, path):
    """What GitHub would not render: a brace or a \\left too many, or what Markdown reads first."""
    bare = re.sub(r"\\[{}]", "", equation)
    if bare.count("{") != bare.count("}"):
        raise BookFault(f"{path}: braces do not match in {equation.strip()}")
    if equation.count("\\left") != equation.count("\\right"):
        raise BookFault(f"{path}: \\left and \\right do not match in {equation.strip()}")
    taken = re.search(r"\\[,;!\\{}]|\*", equation)
    if taken:
        raise BookFault(f"{path}: Markdown would take {taken.group(0)} of {equation.strip()}")


class Book:
    def __init__(self, root, models):
        self.root = root
        self.models = {m["name"]: m for m in models}
        self.listings = Listings(root)
        self.functions = functions_of_models(root)
        self.references = references(root)

    def fragment(self, path):
        text = read(self.root, f"docs/shading/{path}.md").strip()
        for equation in re.findall(r"\$\$?([^$]+)\$?\$", text):
            check_equation(equation, f"docs/shading/{path}.md")
        return self.listings.with_links(text)

    def model(self, name):
        model = self.models[name]
        if name not in self.functions:
            raise BookFault(f"models.def has no row of {name}")
        if model["reference"] not in self.references:
            raise BookFault(f"docs/references.md has no `{model['reference']}`, which {name} names")
        links = " and ".join(self.listings.link(f) for f in self.functions[name])
        return [f"### {name}", "", model["text"], "",
                f"Listing: {links}. {properties(model)}.", "",
                self.fragment(name), "", f"Source: {self.references[model['reference']]}", "",
                *parameter_table(model), *pictures_of(self.root, name)]

    def groups(self):
        """Groups with the models that there are; every one of them must be in a group."""
        known = {name for _, names in GROUPS for name in names}
        strays = sorted(set(self.models) - known)
        if strays:
            raise BookFault(f"scripts/shading_book.py puts {', '.join(strays)} into no group")
        present = [(title, [n for n in names if n in self.models]) for title, names in GROUPS]
        return [(title, names) for title, names in present if names]

    def contents(self):
        lines = [f"- [{title}](#{anchor(title)})" for title, _ in BLOCKS]
        for title, names in self.groups():
            links = ", ".join(f"[{name}](#{name})" for name in names)
            lines.append(f"- [{title}](#{anchor(title)}): {links}")
        return lines

    def text(self):
        lines = ["# Shading: the models and their equations", "",
                 "Made by `scripts/make_shading_book` from `docs/shading/`, the registry and the",
                 "sources; change those, not this file. Equations have the code's letters.", "",
                 *self.contents(), ""]
        for title, name in BLOCKS:
            lines += [f"## {title}", "", self.fragment(f"blocks/{name}"), ""]
        for title, names in self.groups():
            lines += [f"## {title}", ""]
            for name in names:
                lines += self.model(name)
        return "\n".join(lines).rstrip() + "\n"


def anchor(title):
    """As GitHub makes it of a heading."""
    return re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")
