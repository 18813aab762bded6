"""A small tree makes a book; each kind of fault, planted into it, must be found.

usage: shading_book_test.py SCRIPTS-FOLDER
"""
import os
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import shading_book

MODEL = {"name": "lambert", "text": "The same radiance.", "reference": "Lambert1760",
         "reciprocal": True, "conserving": True, "transmissive": False, "parameters": [
             {"name": "base_color", "type": "color", "default": [0.5, 0.5, 0.5], "minimum": 0.0,
              "maximum": 1.0, "mayExceed": False, "text": "reflectance"}]}
TREE = {
    "docs/references.md": "- `Lambert1760`: Lambert 1760.\n  *Photometria.*\n",
    "docs/shading/lambert.md": "$$ f = \\frac{\\rho}{\\pi} $$\n\nSee [[warp]].\n",
    "src/shading/bsdf/models.def":
        "BSDF_MODEL(MODEL_LAMBERT, lambert, lambert_eval,\n           lambert_sample, a, b, 0u,\n",
    "src/shading/bsdf/lambert.glsl":
        "// Lambert.\n\nBsdfValue lambert_eval(vec3 wo) {\n}\nBsdfSample lambert_sample() {\n}\n"
        "vec3 warp(vec2 u) {\n}\n",
    **{f"docs/shading/blocks/{name}.md": "text\n" for _, name in shading_book.BLOCKS},
}
# What is changed, into what (None: taken away), and words of the message.
PLANTED = {
    "no fragment": ("docs/shading/lambert.md", None, "lambert.md is missing"),
    "no block": ("docs/shading/blocks/masking.md", None, "masking.md is missing"),
    "a listing of nothing": ("docs/shading/lambert.md", "[[no_such]]\n", "no function no_such"),
    "eval is gone": ("src/shading/bsdf/lambert.glsl", "vec3 warp(vec2 u) {\n}\n", "lambert_eval"),
    "no row": ("src/shading/bsdf/models.def", "", "no row of lambert"),
    "no reference": ("docs/references.md", "", "Lambert1760"),
    "braces": ("docs/shading/lambert.md", "$$ \\frac{a}{b $$\n", "braces"),
    "left without right": ("docs/shading/lambert.md", "$\\left(a$\n", "right"),
    "Markdown in an equation": ("docs/shading/lambert.md", "$$ a \\, b $$\n", "Markdown"),
}


def book_of(files, models):
    with tempfile.TemporaryDirectory() as root:
        for path, text in files.items():
            if text is not None:
                full = os.path.join(root, path)
                os.makedirs(os.path.dirname(full), exist_ok=True)
                with open(full, "w", encoding="utf-8") as file:
                    file.write(text)
        return shading_book.Book(root, models).text()


def fault_of(files, models):
    try:
        book_of(files, models)
    except shading_book.BookFault as fault:
        return str(fault)
    return "no fault"


def main():
    text = book_of(TREE, [MODEL])
    for part in ("### lambert", "[`lambert_eval`](../src/shading/bsdf/lambert.glsl#L3)",
                 "[`lambert_sample`](../src/shading/bsdf/lambert.glsl#L5)",
                 "See [`warp`](../src/shading/bsdf/lambert.glsl#L7).", "Reciprocal, conserving.",
                 "Source: Lambert 1760. *Photometria.*",
                 "| `base_color` | color | 0.5 | 0 to 1 | reflectance |"):
        assert part in text, (part, text)
    for what, (path, changed, words) in PLANTED.items():
        assert path in TREE, path
        fault = fault_of({**TREE, path: changed}, [MODEL])
        assert words in fault, (what, fault)
    stray = fault_of(TREE, [MODEL, {**MODEL, "name": "stray"}])
    assert "stray into no group" in stray, stray
    print(f"{len(PLANTED) + 1} planted faults were found")


if __name__ == "__main__":
    main()
