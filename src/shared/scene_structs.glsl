// What a scene is made of in the eyes of the kernels. One text for both languages: C++ reads it
// through shared/scene_structs.h, which also checks sizes; vec3 is always followed by one scalar,
// so that std430 and C++ agree on every offset.
#ifndef GP_SHARED_SCENE_STRUCTS_GLSL
#define GP_SHARED_SCENE_STRUCTS_GLSL

#define NO_INDEX 0xFFFFFFFFu

// Hit::instance of things that are no instance.
#define HIT_NOTHING 0xFFFFFFFFu
#define HIT_LIGHT 0xFFFFFFFEu  // the shape of a light; Hit::primitive is its index

struct Hit {
    float t;
    float u;         // barycentrics of the second and third vertex
    float v;
    uint instance;
    uint primitive;
};

// Bits of MaterialRecord::flags.
#define MATERIAL_DOUBLE_SIDED 1u
#define MATERIAL_UNLIT 2u
#define MATERIAL_SOLID 4u        // transmissive body with an inside
#define MATERIAL_TRANSMISSIVE 8u
#define MATERIAL_EMISSIVE 16u
#define MATERIAL_VERTEX_COLOR 32u // colours of vertices, or texture layers (SLOT_LAYERS)
#define MATERIAL_ALPHA_MASK 128u
#define MATERIAL_ALPHA_BLEND 256u
#define MATERIAL_MATTE 1024u     // no metal, no reflection, no layers: Lambertian
#define MATERIAL_NEEDS_UV 512u   // vertex colours or tangents, although no texture is there
#define MATERIAL_LAYERED 64u     // any of specular textures, coat, sheen, transmission, iridescence
#define MATERIAL_LIBRARY 2048u   // a model of the library, not the glTF one: MaterialRecord::bsdf
#define MATERIAL_SEA 65536u      // … with the waves of the scene's sea: kernels/ocean_surface.glsl
#define MATERIAL_PREPARE 4096u   // … whose parameters are prepared at each point: they vary
#define MATERIAL_GLINT 8192u     // … which is MODEL_GLINT: it is told the pixel's footprint

#define MATERIAL_ONLY_BENT 16384u  // slope maps make nothing rough, so that tangents stay

// Light from behind the triangle counts: it shines through, or on slopes that the triangle lacks.
#define MATERIAL_LIT_FROM_BELOW (MATERIAL_TRANSMISSIVE | MATERIAL_SEA)

// Bits of MaterialRecord::textures: which slots hold a texture.
#define SLOT_BASE_COLOR 1u
#define SLOT_METALLIC_ROUGHNESS 2u
#define SLOT_NORMAL 4u
#define SLOT_EMISSION 8u
#define SLOT_SPECULAR 16u
#define SLOT_SPECULAR_COLOR 32u
#define SLOT_COAT 64u
#define SLOT_COAT_ROUGHNESS 128u
#define SLOT_COAT_NORMAL 256u
#define SLOT_SHEEN_COLOR 512u
#define SLOT_SHEEN_ROUGHNESS 1024u
#define SLOT_TRANSMISSION 2048u
#define SLOT_ANISOTROPY 4096u
#define SLOT_IRIDESCENCE 8192u
#define SLOT_IRIDESCENCE_THICKNESS 16384u
#define SLOT_SLOPES 65536u       // not a slot: MaterialSlopes from first_slopes on
#define SLOT_LAYERS 32768u       // not a slot: TextureLayerRecords from first_texture_layer on

// An image of slope moments (kernels/slope_map.glsl).
struct SlopeMapSize {
    uint width;      // of level 0
    uint height;
    uint levels;
    uint repeats;    // 1: along both axes, mirrored or not; else clamped along one at least
};

struct TextureSlot {
    vec4 row_u;      // u' = x u + y v + z
    vec4 row_v;
    uint texture_index;
    uint tex_coord;  // 0 or 1
    uint pad0;
    uint pad1;
};

// gp::Material with its textures as indices; multipliers of what the textures hold.
struct MaterialRecord {
    vec4 base_color;
    vec3 emission;
    float metallic;
    vec3 specular_color;
    float roughness;
    vec3 sheen_color;
    float sheen_roughness;
    vec3 attenuation;      // 1/m: Beer-Lambert coefficient inside a solid
    float ior;
    float specular;
    float coat;
    float coat_roughness;
    float normal_scale;
    float coat_normal_scale;
    float transmission;
    float anisotropy;
    float anisotropy_rotation;
    float iridescence;
    float iridescence_ior;
    float iridescence_thickness_min_nm;
    float iridescence_thickness_max_nm;
    uint flags;
    uint textures;
    uint model;            // row of shading/bsdf/models.def
    float alpha_cutoff;
    uint bsdf;             // MATERIAL_LIBRARY: its parameters, for load_bsdf
    uint first_layer;      // … and what is blended over them: BsdfLayerRecord
    uint layer_count;
    uint first_texture_layer;  // SLOT_LAYERS
    uint first_slopes;     // SLOT_SLOPES
    uint pad0;
    uint pad1;
    uint pad2;
    TextureSlot base_color_slot;
    TextureSlot metallic_roughness_slot;
    TextureSlot normal_slot;
    TextureSlot emission_slot;
    TextureSlot specular_slot;
    TextureSlot specular_color_slot;
    TextureSlot coat_slot;
    TextureSlot coat_roughness_slot;
    TextureSlot coat_normal_slot;
    TextureSlot sheen_color_slot;
    TextureSlot sheen_roughness_slot;
    TextureSlot transmission_slot;
    TextureSlot anisotropy_slot;
    TextureSlot iridescence_slot;
    TextureSlot iridescence_thickness_slot;
};

// A layer of a material made of the library's models: it replaces the share weight times mask of
// the parameters below it.
struct BsdfLayerRecord {
    TextureSlot mask_slot;
    uint channel;          // of the mask, 0 to 3; NO_INDEX: the weight alone counts
    float weight;
    uint bsdf;             // its parameters, for load_bsdf
    uint squared;          // 1: the mask counts by its square, as widths go with roughness
};

// How a texture layer meets the colour below it: GpLayerBlend.
#define LAYER_OPAQUE 0u
#define LAYER_ALPHA 1u
#define LAYER_ADD 2u
#define LAYER_SHADE 3u

// A texture over the base colour (kernels/texture_layers.glsl); those of a material stand together.
struct TextureLayerRecord {
    TextureSlot slot;
    vec4 color;        // multiplies the texture
    vec3 tint;         // the instance's colour, which multiplies what comes out of the last layer
    uint blend;
    uint has_texture;
    uint is_last;
    uint pad0;
    uint pad1;
};

// A map of slopes (kernels/material_slopes.glsl); those of a material stand together.
struct MaterialSlopes {
    TextureSlot slot;  // where it is read; its texture_index is not one
    vec2 to_x;         // the slope along the tangent is to_x.x and to_x.y times those of the map,
    vec2 to_y;         // that along the bitangent likewise
    vec2 rise;         // not 0: gp::SlopeMap::rise in metres of the mesh, whose triangle then says
                       // what the slopes are, and to_x and to_y are not read
    uint slope_map;    // for load_slope_map
    uint is_last;
};

// An instance: rows of its matrices, and what its triangles look like.
struct InstanceRecord {
    vec4 world_from_object[3];
    vec4 normal_from_object[3];  // cofactors of the 3x3: right for any scale, mirrored too
    uint material;
    uint geometry;       // index of the vertex arrays
    uint light_map;      // offset of its triangles in the triangle-to-light table, or NO_INDEX
    uint mirrored;       // 1: the transform turns counter-clockwise into clockwise
};

// One triangle's corners, as load_triangle gives them.
struct TriangleCorners {
    vec3 p0;
    uint normal0;
    vec3 p1;
    uint normal1;
    vec3 p2;
    uint normal2;
    vec2 uv0;
    vec2 uv1;
    vec2 uv2;
    uint tangent0;
    uint tangent1;
    uint tangent2;
    uint pad0;
};

#define LIGHT_TRIANGLE 0u
#define LIGHT_SPHERE 1u
#define LIGHT_RECTANGLE 2u
#define LIGHT_SPOT 3u
#define LIGHT_DIRECTIONAL 4u

// A light that can be chosen: one emissive triangle, a gp::Light, or a triangle of a polygon, whose
// instance is NO_INDEX and whose primitive is its place in the polygon.
struct LightRecord {
    vec3 position;   // sphere, spot: centre; rectangle, triangle: first corner
    uint kind;
    vec3 edge_u;     // rectangle, triangle
    float radius;    // sphere, spot: metres; directional: radians
    vec3 edge_v;
    uint two_sided;
    vec3 direction;  // spot, directional: of travel; rectangle, triangle: unit normal that emits
    float area;      // rectangle, triangle
    vec3 emission;   // radiance; of points W/sr; directional: W/m^2
    float cos_inner;
    float cos_outer;
    uint instance;   // triangle
    uint primitive;
    uint leaf;       // in the light tree: its place in its node, as LightTreeNode::parent
};

// The waves within a footprint (gp::Sea::slopes), of slopes as in shading/slope/slopes.glsl.
struct SeaSlopes {
    vec2 mean;
    float var_x;
    float var_y;
    float cov;
    float foam;      // share of the footprint that is covered
};

// A node of the light tree: what bounds each of its children in position, power and direction
// (shading/light/tree.glsl), number by number, so that all are weighed at once.
#define LIGHT_TREE_WIDTH 8
#define LIGHT_TREE_LEAF 0x80000000u       // LightTreeNode::child: a light, not a node
#define LIGHT_TREE_TWO_SIDED 0x40000000u
#define LIGHT_TREE_INDEX 0x3FFFFFFFu
struct LightTreeNode {
    float centre_x[LIGHT_TREE_WIDTH];
    float centre_y[LIGHT_TREE_WIDTH];
    float centre_z[LIGHT_TREE_WIDTH];
    float radius2[LIGHT_TREE_WIDTH];
    float phi[LIGHT_TREE_WIDTH];          // 0: there is no such child
    float axis_x[LIGHT_TREE_WIDTH];
    float axis_y[LIGHT_TREE_WIDTH];
    float axis_z[LIGHT_TREE_WIDTH];
    float cos_theta_o[LIGHT_TREE_WIDTH];
    float cos_theta_e[LIGHT_TREE_WIDTH];
    uint child[LIGHT_TREE_WIDTH];         // LIGHT_TREE_ bits and an index
    uint parent;  // LIGHT_TREE_WIDTH times the node above, and this one's place in it; 0: the root
    uint pad0[7];
};

// A cell of the table that environment directions are chosen from: an alias table whose cells lie
// over the image's unit square in Morton order. Cell i itself is taken with probability `keep`,
// else `alias`.
struct EnvironmentCell {
    float keep;
    uint alias;
};

// Bits of FrameConstants::sky. None: the environment is all that surrounds the scene, else its
// table only says where light comes from.
#define SKY_TRACED 1u  // sky geometry lies before it (kernels/sky.glsl)
#define SKY_DRAWN 2u   // rasterised geometry too: rays see the table, but those of the camera do
                       // not, into whose picture it is drawn later
// Beside them: rays of the camera that meet nothing see no sky and no sun.
#define SKY_HIDDEN 4u

// Bits of FrameConstants::water.
#define WATER_CAMERA 1u  // the camera is below the sea
#define WATER_BENDS 2u   // shadow rays go through the sea above as if that were calm: real time

// What a frame is, for every kernel: gp::FramePlan and the scene's constants.
struct FrameConstants {
    uint width;
    uint height;
    uint seed;
    uint max_bounces;
    uint diffuse_shading;      // 1: every surface is Lambertian
    uint russian_roulette;     // 1: on
    uint pixel_filter;
    float pixel_filter_radius; // pixels
    float clamp_indirect;      // 0: off
    uint directional_lights;   // how many, from light 0
    uint tree_nodes;           // 0: no other lights
    float environment_power;   // luminance of the irradiance inside a sphere of it; 0: none
    vec3 environment_color;
    float environment_cos;     // of its rotation
    float environment_sin;
    uint only_environment;     // 1: no other light is there to choose
    float environment_visibility;  // the share of each group's light that arrives, estimated
    float directional_visibility;  // before the first sample: FramePlan::lightVisibility
    float tree_visibility;
    uint environment_cells;    // along each side of its sampling table; 0: uniform
    uint last_by_lights;       // 1: the last surface of a path has a shadow ray, but no other ray
    float ray_length;          // metres: every ray ends there, and what lies beyond is sky
    vec3 background_color;     // the scene's environment, where `sky` is not 0
    uint sky;                  // SKY_ bits
    vec3 sky_viewer;           // where sky geometry is seen from
    uint background_image;     // 1: background_color multiplies an image
    vec3 water_attenuation;    // of the sea's water, 1/m
    uint water;                // WATER_ bits
    float water_var_x;         // of slopes, by which kernels/sea_guide.glsl draws directions
    float water_var_y;
    float water_cov;
    float water_ior;
    float water_level;         // y of the sea at rest; -FLOAT_MAX: there is none
    float water_guided;        // share of directions that are drawn so
    float water_stretch;       // metres that light has gone for each metre of depth
    float pad0;
    vec3 water_radiance;       // below the surface, of what very deep water sends back
    float pad1;
};

// Where GP_MODE_LOCAL computes light: GpShadingFrequency.
#define FREQUENCY_PIXEL 0u
#define FREQUENCY_VERTEX 1u
#define FREQUENCY_TRIANGLE 2u

// How GP_MODE_LOCAL lights what the camera sees: gp::LocalLighting and the scene's constants.
struct LocalLightingConstants {
    vec3 ambient;             // radiance from all sides; without sky_nodes the environment's mean
                              // is in it
    uint frequency;
    uint falloff;             // FALLOFF_ of shading/light/lamp_point.glsl
    uint lamps;               // the first lights of the table: all but emissive triangles
    uint replaces_materials;  // 1: one model is the reflectance of all surfaces
    uint parallel_view;       // 1: an orthographic camera
    vec3 sky_mean;            // of the environment's radiance
    uint ndf_filter;          // NDF_FILTER_ of shading/slope/ndf_filtering.glsl
    uint sky_nodes;           // facets along each axis that the environment lights; 0: none
    float sky_texel;          // steradians of a texel of sample_sky's finest level, in the middle
                              // of a face
};

#endif
