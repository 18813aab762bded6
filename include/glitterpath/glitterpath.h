/* Glitterpath: a physically based renderer. This is the whole public interface, in C99.
 *
 * The shape of a program (examples/triangle.c is one):
 *
 *     GpDevice device = gpNewDevice(NULL);                 // where the work is done
 *     GpScene scene = gpNewScene(device);                  // what there is to see
 *     gpLoadSceneFile(scene, "helmet.glb", NULL);          // ...or gpNewMesh, gpNewInstance, ...
 *     GpFrame frame = gpNewFrame(device, &(GpFrameDesc){.width = 640, .height = 360});
 *     gpRender(frame, scene, NULL, NULL);                  // camera and options: defaults
 *     gpSaveFrame(frame, "helmet.png", NULL);
 *     gpReleaseFrame(frame); gpReleaseScene(scene); gpReleaseDevice(device);
 *
 * DESCRIPTORS. Every descriptor filled with zeros is valid or lacks only what cannot be guessed
 * (pointers and counts). A field that is zero takes the default written beside it. Where zero is
 * itself a wish (a black colour, a roughness of 0), set that field's bit in `given`: then the
 * value is taken as it stands. NULL for a whole descriptor means all defaults where it is allowed.
 *
 * HANDLES are not pointers to memory: never dereference one. NULL is no object. A call given a
 * handle that was released, or that belongs to another device, fails with
 * GP_ERROR_INVALID_HANDLE and changes nothing. Releasing gives up your handle; the object lives on
 * while something uses it (a mesh in an instance, an instance in a scene). Releasing a device
 * invalidates every handle made from it.
 *
 * ERRORS. Functions return a GpError, or a handle that is NULL on failure. A failed call changes
 * nothing. gpGetError gives the code and a message of one line; a callback can be set.
 *
 * OWNERSHIP. Everything that a descriptor points to is copied before the call returns.
 *
 * THREADS. Calls on different devices are independent. Calls on one device may come from any
 * thread; each locks the device, so they run one after another. During gpRender only
 * gpCancelRender may be called on that device from other threads without waiting.
 * Callbacks must not call into the device, gpCancelRender apart.
 *
 * UNITS. Metres, radians, seconds. Right-handed space. Radiometry in W, W/m^2, W/(m^2 sr) for
 * each of linear Rec. 709 R, G, B. Photometric input is converted with 683 lm/W. Matrices are
 * 3 rows of 4, row after row: the last column is the translation.
 */
#ifndef GLITTERPATH_H
#define GLITTERPATH_H

#include <stddef.h>
#include <stdint.h>

#if defined(GP_STATIC)
#define GP_API
#elif defined(__GNUC__)
#define GP_API __attribute__((visibility("default")))
#else
#define GP_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define GP_VERSION_MAJOR 0
#define GP_VERSION_MINOR 1
#define GP_VERSION_PATCH 0

typedef struct GpDeviceImpl* GpDevice;
typedef struct GpTextureImpl* GpTexture;
typedef struct GpMaterialImpl* GpMaterial;
typedef struct GpMeshImpl* GpMesh;
typedef struct GpSceneImpl* GpScene;
typedef struct GpInstanceImpl* GpInstance;
typedef struct GpLightImpl* GpLight;
typedef struct GpFrameImpl* GpFrame;
typedef struct GpBsdfImpl* GpBsdf;
typedef struct GpImmediateImpl* GpImmediate;

/* ------------------------------------------------------------------------------------ errors */

typedef enum GpError {
    GP_SUCCESS = 0,
    GP_ERROR_UNKNOWN = 1,           /* a fault of ours: please report it */
    GP_ERROR_INVALID_HANDLE = 2,    /* NULL, released, or of another device */
    GP_ERROR_INVALID_ARGUMENT = 3,  /* a NULL pointer, an unknown enum value, a size of zero */
    GP_ERROR_OUT_OF_RANGE = 4,      /* a number outside its range; an index past the end */
    GP_ERROR_NOT_FINITE = 5,        /* NaN or infinity where a number is wanted */
    GP_ERROR_TOO_LARGE = 6,         /* sizes that overflow, or beyond the documented limit */
    GP_ERROR_INVALID_OPERATION = 7, /* right in itself, wrong now: reading before rendering, moving
                                       an instance of a static mesh, a buffer that is too small */
    GP_ERROR_DUPLICATE_ID = 8,      /* an id that another living object of the scene has */
    GP_ERROR_OUT_OF_MEMORY = 9,
    GP_ERROR_UNSUPPORTED = 10,      /* not there in this build or on this machine; a kind of file or
                                       an extension that is not read */
    GP_ERROR_FILE_NOT_FOUND = 11,
    GP_ERROR_FILE_INVALID = 12,     /* truncated, corrupt, not of the kind that this call wants */
    GP_ERROR_FILE_WRITE = 13,
    GP_ERROR_CANCELLED = 14         /* by gpCancelRender or by the progress callback; the frame
                                       holds the samples taken so far */
} GpError;

/* The name of a code, such as "GP_ERROR_NOT_FINITE"; static; never NULL ("GP_ERROR_UNKNOWN" for a
 * number that is no code). Any thread. */
GP_API const char* gpErrorName(GpError error);

/* Called once for each failing call, on the thread of that call. `message` lives during it. */
typedef void (*GpErrorCallback)(void* user, GpError error, const char* message);

/* The first error of this thread on `device` since the last gpGetError, and forgets it.
 * `message`, if not NULL, receives one line that lives until this thread's next call.
 * device NULL: errors of calls that had no valid device (gpNewDevice, released handles). For a
 * device that is not alive it returns GP_ERROR_INVALID_HANDLE. */
GP_API GpError gpGetError(GpDevice device, const char** message);

/* ------------------------------------------------------------------------------------ device */

typedef enum GpBackend {
    GP_BACKEND_AUTO = 0,  /* the best one that works here (today: the CPU) */
    GP_BACKEND_CPU = 1,   /* Embree and oneTBB; any x86-64 machine */
    GP_BACKEND_NULL = 2,  /* checks every call, renders nothing: frames stay black */
    GP_BACKEND_VULKAN = 3 /* not there yet: GP_ERROR_UNSUPPORTED */
} GpBackend;

typedef struct GpDeviceDesc {
    GpBackend backend;              /* GP_BACKEND_AUTO */
    uint32_t threads;               /* 0 = all processors; at most 1024 */
    const char* instructionSet;     /* NULL = best; "x86-64", "avx2" or "avx512" to force one
                                       (tests, benchmarks): GP_ERROR_UNSUPPORTED where
                                       the CPU lacks it */
    GpErrorCallback errorCallback;  /* NULL = none */
    void* errorUser;                /* handed to the callback */
} GpDeviceDesc;

/* NULL on failure: gpGetError(NULL, ...). desc may be NULL. At most 256 devices at one time. */
GP_API GpDevice gpNewDevice(const GpDeviceDesc* desc);
GP_API GpError gpReleaseDevice(GpDevice device);
/* The backend and instruction set in use, such as "CPU (Embree 3.13.5, avx512, 2 threads)";
 * lives as long as the device. NULL on failure. */
GP_API const char* gpGetDeviceName(GpDevice device);

/* ---------------------------------------------------------------------------------- textures */

typedef enum GpColorSpace {
    GP_COLOR_SRGB = 0,  /* 8-bit RGB is decoded when read; alpha never is */
    GP_COLOR_LINEAR = 1 /* numbers as they are: normals, roughness, masks */
} GpColorSpace;

typedef enum GpWrap { GP_WRAP_REPEAT = 0, GP_WRAP_CLAMP = 1, GP_WRAP_MIRROR = 2 } GpWrap;

typedef enum GpFilter {
    GP_FILTER_LINEAR = 0, /* bilinear within a level, linear between levels */
    GP_FILTER_NEAREST = 1
} GpFilter;

typedef enum GpPixelFormat {
    GP_FORMAT_RGBA8 = 0,  /* 4 bytes a pixel */
    GP_FORMAT_RGBA32F = 1 /* 16 bytes a pixel, always linear */
} GpPixelFormat;

typedef struct GpTextureDesc {
    uint32_t width, height;   /* 1..32768; at most 2^28 pixels */
    GpPixelFormat format;     /* GP_FORMAT_RGBA8 */
    const void* pixels;       /* top row first */
    size_t rowBytes;          /* 0 = tightly packed */
    GpColorSpace colorSpace;  /* GP_COLOR_SRGB */
    GpWrap wrapU, wrapV;      /* GP_WRAP_REPEAT */
    GpFilter magFilter, minFilter; /* GP_FILTER_LINEAR */
    int32_t noMipmaps;        /* not 0: only the image itself is read */
    const char* name;         /* for people; may be NULL */
} GpTextureDesc;

/* Cost: builds the mip chain. */
GP_API GpTexture gpNewTexture(GpDevice device, const GpTextureDesc* desc);
/* From PNG, JPEG, Radiance HDR or EXR. Of `desc` only colour space, wraps, filters, noMipmaps and
 * name count; it may be NULL. */
GP_API GpTexture gpNewTextureFromFile(GpDevice device, const char* path, const GpTextureDesc* desc);
GP_API GpError gpReleaseTexture(GpTexture texture);

/* A rectangle of new pixels. */
typedef struct GpTextureUpdate {
    uint32_t x, y;            /* its upper left pixel in the texture */
    uint32_t width, height;   /* at least 1 each; must lie inside of the texture */
    GpPixelFormat format;     /* the texture's: files of 8 bits a channel make GP_FORMAT_RGBA8,
                                 all others GP_FORMAT_RGBA32F, and floats are always linear */
    const void* pixels;       /* of the rectangle alone, top row first; required */
    size_t rowBytes;          /* 0 = tightly packed */
} GpTextureUpdate;

/* New pixels at any time; every material with this texture, and every scene with such a material,
 * shows them from the next gpRender on, light of emission textures included. Cost: the mip chain
 * below the rectangle. Another format is GP_ERROR_INVALID_ARGUMENT, a rectangle that leaves the
 * texture GP_ERROR_OUT_OF_RANGE; a texture in whose place a file stands (gpSetTextureOverrides) is
 * GP_ERROR_INVALID_OPERATION. */
GP_API GpError gpUpdateTexture(GpTexture texture, const GpTextureUpdate* update);

/* Files that stand in the place of textures by name, such as those of a mod. For a texture that
 * has the name "walls/brick" FOLDER/walls/brick + POSTFIX + ENDING is looked for; the endings
 * are .png, .jpg, .jpeg, .exr and .hdr, in this order, and the postfixes those of three maps:
 *   albedo  RGB base colour (8-bit files: sRGB) and alpha; takes the place of the pixels
 *   rme     R roughness, G metallic, B emission, linear; what is emitted is B times the colour of
 *           the albedo map (of the texture's first pixels where there is none), in W/(m^2 sr)
 *   normal  tangent space, Y up, linear
 * rme and normal go into materials that use the texture as baseColorTexture, where their
 * descriptor leaves normalTexture, metallicRoughnessTexture or emissionTexture NULL, with the
 * coordinates and transform of baseColorTexture. The factors multiply them as always, but a
 * metallic or an emission of 0 counts as 1 there. */
typedef struct GpTextureOverrides {
    const char* folder;        /* required */
    const char* albedoPostfix; /* NULL = "_albedo"; may be "" */
    const char* rmePostfix;    /* NULL = "_rme" */
    const char* normalPostfix; /* NULL = "_n" */
} GpTextureOverrides;

/* For all textures made from now on; NULL ends it. A file that is not there is no error; one that
 * cannot be read is an error of gpNewTexture, with the file's name. Names that are absolute or
 * contain ".." are never looked for. A folder that is not there is GP_ERROR_FILE_NOT_FOUND; two
 * postfixes that are the same are GP_ERROR_INVALID_ARGUMENT. */
GP_API GpError gpSetTextureOverrides(GpDevice device, const GpTextureOverrides* overrides);

/* --------------------------------------------------------------------------------- materials */

/* A texture in a material: u' = transform[0] u + transform[1] v + transform[2], v' likewise with
 * [3..5]. A transform of six zeros is the identity. */
typedef struct GpTextureUse {
    GpTexture texture;  /* NULL = none: the factor alone counts */
    uint32_t texCoord;  /* which set of the mesh: 0 or 1 */
    float transform[6];
} GpTextureUse;

typedef enum GpAlphaMode {
    GP_ALPHA_OPAQUE = 0,
    GP_ALPHA_MASK = 1, /* there where alpha >= alphaCutoff */
    GP_ALPHA_BLEND = 2 /* covers the fraction alpha of what lies behind */
} GpAlphaMode;

/* Bits of GpMaterialDesc.given: "this field counts although it is zero". */
enum {
    GP_GIVEN_BASE_COLOR = 1 << 0,
    GP_GIVEN_ROUGHNESS = 1 << 1,
    GP_GIVEN_NORMAL_SCALE = 1 << 2,
    GP_GIVEN_ALPHA_CUTOFF = 1 << 3,
    GP_GIVEN_SPECULAR = 1 << 4,
    GP_GIVEN_SPECULAR_COLOR = 1 << 5,
    GP_GIVEN_COAT_NORMAL_SCALE = 1 << 6,
    GP_GIVEN_ATTENUATION_COLOR = 1 << 7,
    GP_GIVEN_IRIDESCENCE_THICKNESS = 1 << 8,
    GP_GIVEN_ALL_MATERIAL = (1 << 9) - 1
};

/* Parameters that are blended over those below: share = weight * mask. */
typedef struct GpMaterialLayer {
    GpBsdf bsdf;           /* required; of the same model as `bsdf` of the material */
    float weight;          /* 0..1; 0 = 1 */
    GpTextureUse mask;     /* linear; NULL = the weight alone */
    uint32_t maskChannel;  /* 0 red, 1 green, 2 blue, 3 alpha */
} GpMaterialLayer;

/* How a texture layer meets the colour below it, in linear light, channel by channel. */
typedef enum GpLayerBlend {
    GP_LAYER_OPAQUE = 0, /* in its place */
    GP_LAYER_ALPHA = 1,  /* over it: below (1 - a) + layer a */
    GP_LAYER_ADD = 2,    /* the sum, at most 1 */
    GP_LAYER_SHADE = 3   /* twice the product, at most 1: a layer of 0.5 (188 of an sRGB texture's
                            255) changes nothing. Light maps, detail textures */
} GpLayerBlend;

/* A texture over the base colour of a material. */
typedef struct GpTextureLayer {
    GpTextureUse texture;  /* RGBA, sRGB; NULL = the colour alone */
    float color[4];        /* multiplies the texture; linear, 0..1; four zeros = white */
    GpLayerBlend blend;    /* GP_LAYER_OPAQUE */
} GpTextureLayer;

/* What the picture of a slope map is of. */
typedef enum GpSlopeMapKind {
    GP_SLOPE_MAP_NORMAL = 0,      /* normals in tangent space, as normalTexture */
    GP_SLOPE_MAP_HEIGHT = 1,      /* R: how far the surface stands out along its normal */
    GP_SLOPE_MAP_DISPLACEMENT = 2 /* RGB: how far its points go along +u, against v (towards the
                                     picture's upper edge) and along the normal */
} GpSlopeMapKind;

/* A map whose details may be smaller than a pixel: what a pixel covers of it has a mean slope, that
 * bends the surface, and a spread of slopes, which widens highlights. Nothing is moved: silhouettes
 * and shadows stay. Filters and noMipmaps of the texture do not count. 8 bits are coarse steps for
 * heights: use 16-bit PNG or EXR files. */
typedef struct GpSlopeMap {
    GpTextureUse texture;  /* required; linear */
    GpSlopeMapKind kind;   /* GP_SLOPE_MAP_NORMAL */
    float scale;           /* any; 0 = 1. Of normals: multiplies their slopes. Else lengths in the
                              mesh's own space (metres where instances do not scale it) that a value
                              of 1 stands for; below 0 turns hills into dents */
    float extent[2];       /* displacement: lengths, in the unit of scale, that the whole picture
                              covers along u and v, above 0, which sideways motion is measured by;
                              two zeros = (1, 1). Other kinds: zeros */
} GpSlopeMap;

/* glTF 2.0 metallic-roughness with the Khronos extensions; a texture multiplies its factor. All
 * factors are in 0..1 unless said otherwise. Or, where `bsdf` is set, any model of the library. */
typedef struct GpMaterialDesc {
    uint32_t given; /* GP_GIVEN_ bits */
    const char* name;
    float baseColor[4];            /* linear RGB and alpha; (1,1,1,1) */
    GpTextureUse baseColorTexture; /* RGBA, sRGB */
    float metallic;                /* 0 */
    float roughness;               /* 1; its square is the microfacet width alpha */
    GpTextureUse metallicRoughnessTexture; /* G roughness, B metallic; linear */
    GpTextureUse normalTexture;    /* tangent space, Y up; linear */
    float normalScale;             /* 1; any */
    float emission[3];             /* radiance, W/(m^2 sr), >= 0; 0 */
    GpTextureUse emissionTexture;  /* RGB, sRGB */
    GpAlphaMode alphaMode;         /* GP_ALPHA_OPAQUE */
    float alphaCutoff;             /* 0.5 */
    int32_t doubleSided;           /* not 0: emission leaves both sides. (Surfaces are seen from
                                      both sides in any case.) */
    int32_t unlit;                 /* not 0: shows baseColor as it is and casts no light */
    float ior;                     /* 1.5; 1..10 */
    float specular;                /* 1 */
    GpTextureUse specularTexture;  /* A */
    float specularColor[3];        /* (1,1,1) */
    GpTextureUse specularColorTexture; /* RGB, sRGB */
    float coat;                    /* 0 */
    GpTextureUse coatTexture;      /* R */
    float coatRoughness;           /* 0 */
    GpTextureUse coatRoughnessTexture; /* G */
    GpTextureUse coatNormalTexture;
    float coatNormalScale;         /* 1 */
    float sheenColor[3];           /* 0 */
    GpTextureUse sheenColorTexture;     /* RGB, sRGB */
    float sheenRoughness;          /* 0 */
    GpTextureUse sheenRoughnessTexture; /* A */
    float transmission;            /* 0 */
    GpTextureUse transmissionTexture;   /* R */
    int32_t solid;                 /* 0: a thin sheet, no inside. Not 0: the surface bounds a body
                                      that refracts and absorbs; the mesh should be closed */
    float attenuationColor[3];     /* (1,1,1): what is left after attenuationDistance */
    float attenuationDistance;     /* metres; 0 = infinite */
    float anisotropy;              /* 0 */
    float anisotropyRotation;      /* radians from the tangent */
    GpTextureUse anisotropyTexture; /* RG direction, B strength */
    float iridescence;             /* 0 */
    GpTextureUse iridescenceTexture; /* R */
    float iridescenceIor;          /* 1.3; 1..10 */
    float iridescenceThicknessMinNm; /* 100 */
    float iridescenceThicknessMaxNm; /* 400 */
    GpTextureUse iridescenceThicknessTexture; /* G, from min to max */
    /* A model of the library instead (gpNewBsdf); NULL = glTF's as above. Then baseColor and its
     * texture multiply the model's base_color, if it has one; of the other fields only normal map,
     * slope maps, emission, alpha, doubleSided, unlit, attenuation and anisotropyRotation (it turns
     * the tangent) count, and setting another is GP_ERROR_INVALID_ARGUMENT. Handles may be released
     * after the call. */
    GpBsdf bsdf;
    const GpMaterialLayer* layers; /* blended over bsdf, in this order: parameters, not results */
    uint32_t layerCount;           /* at most 16 */
    const char* preset;            /* in the place of bsdf and layers: any word that a GpBsdfDesc
                                      takes as model; stacks of a file bring their masks */
    /* Over base colour times its texture, in this order; what comes out is multiplied by the
     * colours of vertices and of the instance. Alpha stays that of the base. */
    const GpTextureLayer* textureLayers;
    uint32_t textureLayerCount;    /* at most 2 */
    /* One over the other and over normalTexture: their slopes add up. How steep heights are is said
     * by each triangle's texture coordinates. Every model is bent by their mean; their spread goes
     * into the highlights of glTF's material without `bsdf` and of the models glint, ggx_conductor,
     * ggx_dielectric and beckmann_conductor. The model glint takes normalTexture as one of them,
     * all others bend it as it is. Coats stay smooth. GP_ERROR_UNSUPPORTED for heights or
     * displacements whose texture is GP_WRAP_MIRROR. Cost: memory of 21 bytes a texel for each
     * texture and kind (and lengths, of displacements), made at the next gpRender. */
    const GpSlopeMap* slopeMaps;
    uint32_t slopeMapCount;        /* at most 4 */
} GpMaterialDesc;

/* desc may be NULL: white and diffuse with a dielectric sheen of its index. */
GP_API GpMaterial gpNewMaterial(GpDevice device, const GpMaterialDesc* desc);
GP_API GpError gpReleaseMaterial(GpMaterial material);
/* A material that shows one of `count` others, the first to begin with; gpSetMaterialFrame chooses.
 * It is used like any other; its name is that of the one that shows. 1..65536 frames, none of them
 * animated itself (GP_ERROR_INVALID_ARGUMENT); their handles may be released after the call. */
GP_API GpMaterial gpNewAnimatedMaterial(GpDevice device, const GpMaterial* frames, uint32_t count);
/* From the next gpRender on every mesh and instance with this animated material shows that frame,
 * counted from 0, light that it sends included. Past the end is GP_ERROR_OUT_OF_RANGE; a material
 * that is not animated GP_ERROR_INVALID_OPERATION. */
GP_API GpError gpSetMaterialFrame(GpMaterial material, uint32_t frame);
/* Gives `material` to every instance of the scene whose material has this name; name NULL: to all
 * instances. *replaced (may be NULL) receives how many those are, which may be 0. */
GP_API GpError gpReplaceMaterial(GpScene scene, const char* name, GpMaterial material,
                                 uint32_t* replaced);

/* What of a material varies over its surface, or belongs to the thing and not to its reflectance:
 * bits. Textures come with their factors, coordinates and transforms. */
enum {
    GP_MAP_BASE_COLOR = 1 << 0, /* baseColor, its texture and textureLayers */
    GP_MAP_NORMAL = 1 << 1,     /* normalTexture */
    GP_MAP_SLOPES = 1 << 2,     /* slopeMaps */
    GP_MAP_ALPHA = 1 << 3,      /* alphaMode, where it is not opaque, and whose alpha it looks at */
    GP_MAP_EMISSION = 1 << 4,   /* emission with its texture, and doubleSided */
    GP_MAP_ROUGHNESS = 1 << 5,  /* green of metallicRoughnessTexture */
    GP_MAP_METALLIC = 1 << 6,   /* its blue */
    GP_MAP_ALL = (1 << 7) - 1,
    GP_MAP_OTHERS = 1 << 7      /* the other textures, and masks of layers: only in
                                   GpReplacedMaterials.left */
};

typedef struct GpReplacedMaterials {
    uint32_t instances; /* that have another material now */
    uint32_t kept;      /* GP_MAP_ bits: what their materials had and still have */
    uint32_t left;      /* what they had and the new one has no use for, or was not asked for */
} GpReplacedMaterials;

/* As gpReplaceMaterial, but what `keep` (GP_MAP_ bits) names of each instance's material goes into
 * a copy of `material` with the old one's name, where it has none of its own and a use for it:
 * normals, slopes, alpha, emission in any; base colour (times the copy's baseColor, in place of a
 * model's base_color) where it is read; metal and roughness where it is glTF's own. Roughness also
 * where it is one set of parameters, without layers, of a model other than glint with `roughness`
 * (0 to 1), which then is that of the old material, or alpha_x and alpha_y, which are its square:
 * such parameters are prepared at each point, as under any mask. An animated material is
 * GP_ERROR_INVALID_ARGUMENT. `replaced` may be NULL. */
GP_API GpError gpReplaceMaterialModel(GpScene scene, const char* name, GpMaterial material,
                                      uint32_t keep, GpReplacedMaterials* replaced);

/* ------------------------------------------------------------------------------------ meshes */

typedef enum GpMeshKind {
    GP_MESH_STATIC = 0,  /* nothing changes: best structure, fastest rays */
    GP_MESH_MOVABLE = 1, /* the transforms of its instances may change (gpSetInstanceTransform) */
    GP_MESH_DYNAMIC = 2  /* its vertices may change too (gpUpdateMesh) */
} GpMeshKind;

/* Strides are in bytes; 0 = tightly packed. Vertices and indices: each at most 2^28. */
typedef struct GpMeshDesc {
    uint64_t id;              /* yours, for matching over frames; 0 = none */
    GpMeshKind kind;          /* GP_MESH_STATIC */
    GpMaterial material;      /* NULL = the default material */
    uint32_t vertexCount;
    const float* positions;   /* xyz, finite; required */
    size_t positionStride;
    const float* normals;     /* xyz; NULL = flat normals are generated */
    size_t normalStride;
    const float* tangents;    /* xyz and the bitangent's sign; NULL = generated where needed */
    size_t tangentStride;
    const float* texCoords[2]; /* uv; NULL = zeros */
    size_t texCoordStride[2];
    const float* colors;      /* linear RGBA, 0..1, multiply baseColor; NULL = white */
    size_t colorStride;
    const uint32_t* indices;  /* three a triangle; NULL = vertices in order */
    uint32_t indexCount;      /* a multiple of 3; without indices vertexCount is one */
    const char* name;
} GpMeshDesc;

GP_API GpMesh gpNewMesh(GpDevice device, const GpMeshDesc* desc);
/* New vertices for a GP_MESH_DYNAMIC mesh; kind, id, material and name of desc are ignored.
 * The next gpRender builds its acceleration structure anew, at the quality that is quickest to
 * build. GP_ERROR_INVALID_OPERATION for the other kinds. */
GP_API GpError gpUpdateMesh(GpMesh mesh, const GpMeshDesc* desc);
/* New texture coordinates for a mesh of any kind: uv for each vertex that the mesh was given, in
 * that order; set 0 or 1; stride in bytes, 0 = tightly packed. uv NULL = zeros. Acceleration
 * structures stay as they are. Tangents that were generated follow (where triangles that mirror the
 * texture and others newly share a vertex, each triangle of the mesh takes its own); given ones
 * stay. */
GP_API GpError gpUpdateTexCoords(GpMesh mesh, uint32_t set, const float* uv, size_t stride);
GP_API GpError gpReleaseMesh(GpMesh mesh);

/* ------------------------------------------------------------------------- scenes, instances */

GP_API GpScene gpNewScene(GpDevice device);
GP_API GpError gpReleaseScene(GpScene scene);

enum { GP_VISIBLE_CAMERA = 1, GP_VISIBLE_BOUNCE = 2, GP_VISIBLE_SHADOW = 4 };

/* Whose eyes see an instance. */
typedef enum GpVisibility {
    GP_VISIBILITY_WORLD = 0,        /* everyone's */
    GP_VISIBILITY_FIRST_PERSON = 1, /* the viewer's hands and weapon: the camera sees them; they are
                                       in no reflection, cast no shadow and light nothing */
    GP_VISIBILITY_VIEWER_BODY = 2,  /* the body that the viewer stands in: reflected and casting
                                       shadows, but the camera looks through it */
    GP_VISIBILITY_SKY = 3           /* sky geometry, a small world of its own: rays of every kind
                                       that meet nothing else see it, all from the one point that
                                       GpRenderOptions.skyViewerPosition says, and before the
                                       environment. It shows its base colour plus its emission
                                       (unlit: the base colour), whatever light there is; what it
                                       shows lights the scene as an environment does. Suns lie
                                       before it, and it is not in the scene's bounds */
} GpVisibility;

typedef struct GpInstanceDesc {
    uint64_t id;            /* yours, unique in the scene; 0 = none */
    GpMesh mesh;            /* required */
    GpMaterial material;    /* NULL = the mesh's */
    float worldFromObject[12]; /* 3 rows of 4; twelve zeros = identity. Must be invertible */
    uint32_t invisibleTo;   /* GP_VISIBLE_ bits of the rays that pass through it, beside those that
                               `visibility` lets pass; 0 = none. What bounced rays do not see lights
                               nothing either */
    const char* name;
    GpVisibility visibility;/* GP_VISIBILITY_WORLD */
    float color[4];         /* linear RGB and alpha, 0..1: multiplies the base colour, as colours of
                               vertices do; four zeros = white. Alpha counts where the material's
                               alphaMode looks at it */
} GpInstanceDesc;

/* The instance belongs to the scene until it is removed; your handle may be released before. */
GP_API GpInstance gpNewInstance(GpScene scene, const GpInstanceDesc* desc);
/* For instances of movable and dynamic meshes; twelve floats, 3 rows of 4. */
GP_API GpError gpSetInstanceTransform(GpInstance instance, const float* worldFromObject);
/* Another material; NULL = the mesh's. */
GP_API GpError gpSetInstanceMaterial(GpInstance instance, GpMaterial material);
/* Four floats, taken as they stand; NULL = white. Each pair of a material and a colour costs about
 * 1 KB in the scene. */
GP_API GpError gpSetInstanceColor(GpInstance instance, const float* color);
/* visibility and invisibleTo of GpInstanceDesc anew. */
GP_API GpError gpSetInstanceVisibility(GpInstance instance, GpVisibility visibility,
                                       uint32_t invisibleTo);
/* Takes it out of its scene and releases the handle. */
GP_API GpError gpRemoveInstance(GpInstance instance);
/* Gives up the handle; the instance stays in its scene. */
GP_API GpError gpReleaseInstance(GpInstance instance);

/* ------------------------------------------------------------------------------------ lights */

typedef enum GpLightKind {
    GP_LIGHT_DIRECTIONAL = 0, /* the sun: parallel, or from a disk of angularRadius */
    GP_LIGHT_SPHERE = 1,      /* or a point, with radius 0 */
    GP_LIGHT_SPOT = 2,        /* a sphere (or point) whose light leaves within a cone */
    GP_LIGHT_RECTANGLE = 3,
    GP_LIGHT_POLYGON = 4      /* flat and convex */
} GpLightKind;

typedef enum GpLightUnit {
    GP_UNIT_RADIOMETRIC = 0, /* directional W/m^2; sphere and spot W/sr; rectangle and polygon
                                W/(m^2 sr) */
    GP_UNIT_PHOTOMETRIC = 1, /* directional lux; sphere and spot candela; rectangle and polygon
                                candela/m^2 */
    GP_UNIT_POWER_W = 2,     /* whole power in watts (not directional). Spots: as if all around */
    GP_UNIT_POWER_LM = 3     /* the same in lumens */
} GpLightUnit;

typedef struct GpLightDesc {
    uint64_t id;          /* yours, unique among the lights of the scene; 0 = none */
    GpLightKind kind;
    float color[3];       /* linear RGB >= 0; three zeros = white */
    float intensity;      /* >= 0, in `unit`; 0 = off */
    GpLightUnit unit;
    float position[3];    /* sphere, spot: centre; rectangle: the corner */
    float direction[3];   /* directional, spot: where the light travels, any length;
                             three zeros = (0, -1, 0) */
    float radius;         /* sphere, spot: metres >= 0 */
    float angularRadius;  /* directional: radians, 0..pi/2; the sun: 0.00465 */
    float innerAngle;     /* spot: radians from the axis, 0..outerAngle */
    float outerAngle;     /* spot: 0 = pi/4; at most pi/2 */
    float edgeU[3], edgeV[3]; /* rectangle: its edges from the corner; light leaves along U x V */
    int32_t twoSided;     /* rectangle, polygon */
    int32_t invisible;    /* not 0: camera rays do not see the sphere, rectangle or polygon */
    const char* name;
    const float* corners; /* polygon: xyz of each, in one plane and convex, within 1e-4 of its size;
                             light leaves on the side that sees them counter-clockwise. For other
                             shapes take several polygons */
    uint32_t cornerCount; /* polygon: 3..1024 */
} GpLightDesc;

GP_API GpLight gpNewLight(GpScene scene, const GpLightDesc* desc);
/* Everything of the light anew; the id stays. */
GP_API GpError gpSetLight(GpLight light, const GpLightDesc* desc);
/* The last light of the scene takes its place among them. */
GP_API GpError gpRemoveLight(GpLight light);
GP_API GpError gpReleaseLight(GpLight light);
/* Light `index` of the scene, from 0, whoever added it: a call, a file or gpSetSky, in the order of
 * gpDescribeScene. Emissive triangles are not among them. `desc` receives what gpSetLight would
 * make it of, in GP_UNIT_RADIOMETRIC; its name and corners live until the light is set or removed.
 * `light`, which may be NULL, receives a handle of its own, to be released. A light that has more
 * than one handle can be removed through any; the others are good for gpReleaseLight then, and
 * GP_ERROR_INVALID_OPERATION for all else. What plays (gpSetSceneTime) still moves its lights. */
GP_API GpError gpGetSceneLight(GpScene scene, uint32_t index, GpLightDesc* desc, GpLight* light);

/* What surrounds the scene. Latitude-longitude images: the centre looks along -Z, top is +Y. */
typedef struct GpEnvironmentDesc {
    uint32_t width, height;  /* of pixels; 0 = no image */
    const float* pixels;     /* RGBA, linear radiance, W/(m^2 sr), >= 0, top row first */
    float color[3];          /* multiplies the image (three zeros = 1); without an image it is the
                                radiance of a uniform surrounding (three zeros = black) */
    float rotation;          /* radians about +Y, counter-clockwise seen from above */
} GpEnvironmentDesc;

/* desc NULL = no environment. Replaces a sky, whose sun goes with it. */
GP_API GpError gpSetEnvironment(GpScene scene, const GpEnvironmentDesc* desc);
/* The image from a Radiance HDR or EXR file; color and rotation from desc, which may be NULL. */
GP_API GpError gpSetEnvironmentFromFile(GpScene scene, const char* path,
                                        const GpEnvironmentDesc* desc);

/* Six square pictures of what surrounds the scene, with the orientation that OpenGL gives the faces
 * of a cube map (OpenGL 4.6 specification, table 8.19): the first row of a face's pixels is t = 0.
 * Seen from the origin, -Z ahead and +Y up, each side face stands upright and mirrored (cube maps
 * are left-handed); worldFromCube may mirror them back. */
typedef struct GpCubemapDesc {
    GpTexture faces[6];      /* +X, -X, +Y, -Y, +Z, -Z: RGB is radiance, W/(m^2 sr), >= 0 (8 bits:
                                1 is white), alpha is not read. All required; square and of one
                                size, 1..4096. May be released after the call, and gpUpdateTexture
                                does not reach the scene's copy */
    float color[3];          /* multiplies them; three zeros = 1 */
    float worldFromCube[9];  /* 3 rows of 3: where the cube's axes point; at right angles and of
                                length 1 within 1e-3; nine zeros = identity */
} GpCubemapDesc;

/* Replaces the environment, and a sky with its sun. The cube becomes a latitude-longitude image
 * four times as wide as a face (64 x 32 to 8192 x 4096 pixels), and lights as such an image does.
 * Cost: 0.1 s for faces of 256 x 256, on one core. */
GP_API GpError gpSetCubemap(GpScene scene, const GpCubemapDesc* desc);
/* A clear sky with the sun at (azimuth from -Z towards +X, elevation), radians. The sun's disk is a
 * directional light of its own that the call adds. sunElevation: 0..pi/2. sunLux >= 0: illuminance
 * of the sun on a plane facing it; 0 = by its elevation (100,000 lux high up). Replaces the
 * environment, and an earlier sky with its sun. */
GP_API GpError gpSetSky(GpScene scene, float sunAzimuth, float sunElevation, float sunLux);

/* ------------------------------------------------------------------------------------- ocean
 * A sea of waves with the horizon around every camera, one for a scene. Azimuths are radians from
 * -Z towards +X, as for gpSetSky. docs/water.md tells what is computed. */

typedef enum GpOceanSpectrum {
    GP_SPECTRUM_JONSWAP = 0,          /* young and old wind seas, by the fetch */
    GP_SPECTRUM_TMA = 1,              /* the same in shallow water: needs a depth */
    GP_SPECTRUM_PHILLIPS = 2,         /* that of most films and games; no fetch, no depth */
    GP_SPECTRUM_PIERSON_MOSKOWITZ = 3 /* fully grown: no fetch */
} GpOceanSpectrum;

/* Bits of GpOceanDesc.given: "this field counts although it is zero". */
enum {
    GP_GIVEN_WIND = 1 << 0,
    GP_GIVEN_CHOPPINESS = 1 << 1,
    GP_GIVEN_ABSORPTION = 1 << 2,
    GP_GIVEN_SCATTERING = 1 << 3,
    GP_GIVEN_FOAM = 1 << 4,
    GP_GIVEN_ALL_OCEAN = (1 << 5) - 1
};

/* What the smallest waves are, which no map holds. */
typedef enum GpOceanGlints {
    GP_GLINTS_OFF = 0,     /* a smooth distribution of slopes */
    GP_GLINTS_ON = 1,      /* facets that can be counted, from a dictionary */
    GP_GLINTS_COUNTING = 2 /* the same at a fixed cost [Deliot and Belcour 2023] */
} GpOceanGlints;

/* How waves below a pixel hide one another. */
typedef enum GpOceanMasking { GP_MASKING_V_CAVITY = 0, GP_MASKING_SMITH = 1 } GpOceanMasking;

typedef struct GpOceanDesc {
    uint32_t given;        /* GP_GIVEN_ bits */
    GpOceanSpectrum spectrum; /* GP_SPECTRUM_JONSWAP */
    float wind;            /* m/s at 10 m above the water, 0..100; 10. 0 (given): a flat sea */
    float windDirection;   /* azimuth that the wind blows towards */
    float fetch;           /* metres of open water that the wind has come over, 100..1e7; 1e5 */
    float depth;           /* metres of water, 0.1..1e4; 0 = deep */
    float swell;           /* 0..1: how much the waves run as long parallel crests; 0 */
    float choppiness;      /* 0..2: horizontal motion, which makes crests sharp; 1 */
    uint32_t seed;         /* another number is another sea of the same weather */
    uint32_t cascades;     /* bands of waves, each with maps of its own: 1..4; 0 = 3 */
    float level;           /* y of the water at rest, metres */
    uint32_t resolution;   /* cells around the viewer, 16..2048: the triangles of the waves that
                              have a shape; finer ones are in the shading. 0 = 384, which makes
                              256,000 vertices; they grow with its square */
    float absorption[3];   /* of the water, 1/m, >= 0; (0.27, 0.065, 0.03): moderately clear sea */
    float scattering[3];   /* backwards, 1/m, >= 0; (0.0016, 0.002, 0.003). Their ratio gives the
                              colour that comes back from below, and to which things in the water
                              fade */
    float ior;             /* 1.01..3; 0 = 1.333 */
    float foam;            /* 0..1: share of what waves that break make; 1 */
    int32_t transparent;   /* 0: nothing below the surface is seen, and what the water sends back
                              is diffuse. Not 0: rays go on into the water, which absorbs and
                              scatters, and see what lies there, or the same colour where nothing
                              does. Sun and sky light it: path traced through the waves, in real
                              time as if the water were calm */
    GpOceanGlints glints;  /* GP_GLINTS_OFF */
    float glintDensity;    /* facets a square metre of the water at rest, 1..1e12; 0 = 1e6 */
    GpOceanMasking masking;/* GP_MASKING_V_CAVITY */
} GpOceanDesc;

/* What of the sea stands above or below a point of the plane. */
typedef struct GpOceanSample {
    float height;          /* y of the surface there, metres */
    float normal[3];       /* unit length, y > 0 */
    float foam;            /* 0..1: how much of it is covered */
} GpOceanSample;

/* desc NULL = no sea. Replaces the one before; its time is 0. Cost: milliseconds for each cascade.
 * It is a part of the scene that every gpRender places around its camera: flat, without the
 * curvature of the earth, out to 5,000 times the camera's height above it (at least 5 km), where
 * it is 0.2 milliradians below the horizontal. No GpInstance stands for it, and it is not in the
 * bounds of the scene. Frames show it as one more instance, whose motion they know. A camera below
 * the surface looks through the water, transparent or not, and out of it. What water scatters is
 * light of suns and sky, as if nothing cast a shadow there and the surface were flat. Frames of
 * GP_MODE_LOCAL and of GP_SHADING_DIFFUSE show no water but its surface. */
GP_API GpError gpSetOcean(GpScene scene, const GpOceanDesc* desc);
/* Where the waves are after so many seconds, -1e6..1e6: the same at the same time, whatever time
 * was before. GP_ERROR_INVALID_OPERATION where the scene has no sea. */
GP_API GpError gpSetOceanTime(GpScene scene, double seconds);
/* The surface at `count` points (x, z), two floats each, at most 2^24, at the time of
 * gpSetOceanTime: for what swims. Waves below the size of the maps' texels are not in it.
 * GP_ERROR_INVALID_OPERATION where the scene has no sea. */
GP_API GpError gpSampleOcean(GpScene scene, size_t count, const float* points,
                             GpOceanSample* samples);
/* The maps that the waves are made of, at the time of gpSetOceanTime, into a folder that is there,
 * as EXR files of 32-bit floats: displacement_0.exr (x, y, up in metres), normal_0, foam_0 and
 * moments_0 (of slopes) of cascade 0, ... _1 of the next. Each tiles; x is towards +X, y (the upper
 * edge) towards -Z. docs/water.md has their channels and lengths. GP_ERROR_INVALID_OPERATION where
 * the scene has no sea. */
GP_API GpError gpSaveOceanMaps(GpScene scene, const char* folder);

/* ------------------------------------------------------------------------------- scene files */

typedef struct GpLoadOptions {
    double time;          /* seconds: where animations, morphs and skins stand */
    uint32_t animation;   /* 0 = the first; n = number n, from 1; needs that many;
                             GP_ALL_ANIMATIONS */
    uint32_t scene;       /* 0 = the file's default; n = number n, from 1 */
    int32_t playable;     /* not 0: keeps in memory what gpSetSceneTime needs; all animations of
                             the file are then checked */
} GpLoadOptions;

/* All animations of a file at once; of two that move the same thing the later one wins. */
#define GP_ALL_ANIMATIONS 0xffffffffu

/* Adds the content of a .gltf or .glb file. On failure the scene is as it was. options may be
 * NULL. Extensions that the file requires and we lack are an error; those that it merely uses
 * are warnings, listed by gpDescribeScene. */
GP_API GpError gpLoadSceneFile(GpScene scene, const char* path, const GpLoadOptions* options);

typedef struct GpPlayOptions {
    uint32_t animation;   /* 0 = those that play already (GpLoadOptions.animation at first); n =
                             number n, from 1, of the list in gpDescribeScene, which plays in its
                             file from now on; GP_ALL_ANIMATIONS = all of all files */
    int32_t loop;         /* not 0: each animation starts again when it is over (its length is the
                             time of its last key); 0: it holds still there */
} GpPlayOptions;

/* Moves what files brought to where it is at `time` seconds: instances, skins, morph targets,
 * cameras and lights, exactly as if they were loaded for that time, but the objects stay the same:
 * an instance keeps its id, a mesh whose vertices do not change its revision. Only files loaded
 * with `playable` count; GP_ERROR_INVALID_OPERATION where the scene has none, or the chosen
 * animation is of another file. GP_ERROR_FILE_INVALID where something would be beyond 1e18 m then.
 * options may be NULL. Cost: that of the vertices of deformed meshes. */
GP_API GpError gpSetSceneTime(GpScene scene, double time, const GpPlayOptions* options);

typedef struct GpSceneInfo {
    uint64_t meshes, triangles;           /* unique */
    uint64_t instances, instancedTriangles;
    uint64_t materials, textures, textureBytes, geometryBytes;
    uint64_t lights, emissiveTriangles, cameras;
    int32_t hasEnvironment;
    float boundsMin[3], boundsMax[3];     /* world, metres; all zeros for an empty scene */
} GpSceneInfo;

GP_API GpError gpGetSceneInfo(GpScene scene, GpSceneInfo* info);
/* Everything in the scene as a JSON text: names, sizes, materials, lights, cameras, animations,
 * warnings. *needed (may be NULL) always receives the size of the text with its closing zero; with
 * size 0 that is all, and text may be NULL. A size below it is GP_ERROR_INVALID_OPERATION, and
 * nothing is written to text. */
GP_API GpError gpDescribeScene(GpScene scene, char* text, size_t size, size_t* needed);

/* ------------------------------------------------------------------------------------ camera */

typedef enum GpCameraKind { GP_CAMERA_PERSPECTIVE = 0, GP_CAMERA_ORTHOGRAPHIC = 1 } GpCameraKind;

typedef struct GpCameraDesc {
    GpCameraKind kind;
    float position[3];
    float target[3];          /* equal to position = one metre along -Z */
    float up[3];              /* three zeros = +Y, or -Z where the view runs along Y; must not be
                                 parallel to the view */
    float verticalFov;        /* radians, 0 = pi/4; below pi */
    float orthographicHeight; /* metres; 0 = 2 */
    float apertureRadius;     /* metres; 0 = pinhole */
    float focusDistance;      /* metres along the view axis; 0 = the target */
} GpCameraDesc;

/* Cameras that files brought, in their order. The name (may be NULL) lives as long as the scene. */
GP_API GpError gpGetSceneCamera(GpScene scene, uint32_t index, GpCameraDesc* camera,
                                const char** name);
/* A camera that shows the whole scene, from the front, a little from above. aspect: width / height
 * of the picture, above 0. */
GP_API GpError gpFrameScene(GpScene scene, float aspect, GpCameraDesc* camera);

/* ------------------------------------------------------------------------------------ frames */

typedef enum GpFrameMode {
    GP_MODE_REFERENCE = 0, /* unbiased path tracing */
    GP_MODE_REALTIME = 1,  /* a few rays a pixel; gpRender makes one frame, and the GpFrame
                              remembers the ones before: see GpRealtimeOptions */
    GP_MODE_LOCAL = 2      /* what a rasteriser shows: see GpLocalLighting */
} GpFrameMode;

typedef struct GpFrameDesc {
    uint32_t width, height; /* 1..16384 */
    GpFrameMode mode;
} GpFrameDesc;

GP_API GpFrame gpNewFrame(GpDevice device, const GpFrameDesc* desc);
GP_API GpError gpReleaseFrame(GpFrame frame);

/* What a frame holds for each pixel, top row first. Those of surfaces are of the first surface that
 * a camera ray meets, averaged over the samples (ids: of the first sample). */
typedef enum GpFrameImage {
    GP_IMAGE_COLOR = 0,     /* RGBA32F  radiance and coverage (alpha) */
    GP_IMAGE_DISPLAY = 1,   /* RGBA8    after exposure, tone mapping and sRGB encoding */
    GP_IMAGE_ALBEDO = 2,    /* RGBA32F  reflectance */
    GP_IMAGE_NORMAL = 3,    /* RGBA32F  shading normal, world space */
    GP_IMAGE_DEPTH = 4,     /* R32F     distance along the view axis, metres; infinite: nothing */
    GP_IMAGE_EMISSION = 5,  /* RGBA32F  radiance of what the camera sees glow, sky included */
    GP_IMAGE_DIRECT = 6,    /* RGBA32F  light after one bounce */
    GP_IMAGE_INDIRECT = 7,  /* RGBA32F  light after more: COLOR = EMISSION + DIRECT + INDIRECT;
                                        GP_MODE_LOCAL: DIRECT by lamps, INDIRECT ambient;
                                        GP_MODE_REALTIME: INDIRECT diffuse light, DIRECT the rest */
    GP_IMAGE_ROUGHNESS = 8, /* RGBA32F  R roughness, G metallic */
    GP_IMAGE_VARIANCE = 9,  /* RGBA32F  variance of the mean in COLOR, as if samples
                                        were independent: an upper bound. Not in
                                        GP_MODE_REALTIME: GP_ERROR_INVALID_OPERATION */
    GP_IMAGE_INSTANCE = 10, /* R32UI    1 + position of the instance in the scene, 0: nothing */
    GP_IMAGE_COUNT = 11
} GpFrameImage;

typedef enum GpImageFormat { GP_IMAGE_RGBA32F = 0, GP_IMAGE_RGBA8 = 1, GP_IMAGE_R32F = 2,
                             GP_IMAGE_R32UI = 3 } GpImageFormat;

typedef struct GpImageInfo {
    const char* name;      /* "color", "display", "albedo", ... */
    GpImageFormat format;
    uint32_t bytesPerPixel;
} GpImageInfo;

/* Name and format of an image kind; needs no device. */
GP_API GpError gpGetImageInfo(GpFrameImage image, GpImageInfo* info);

typedef enum GpTonemap {
    GP_TONEMAP_AGX = 0,
    GP_TONEMAP_ACES = 1,
    GP_TONEMAP_REINHARD = 2,
    GP_TONEMAP_NONE = 3 /* clipped at 1 */
} GpTonemap;

typedef enum GpPixelFilter {
    GP_PIXEL_BLACKMAN_HARRIS = 0, /* 1.5 pixels wide, sharp without ringing */
    GP_PIXEL_BOX = 1,
    GP_PIXEL_TENT = 2,
    GP_PIXEL_GAUSSIAN = 3
} GpPixelFilter;

typedef enum GpShading {
    GP_SHADING_FULL = 0,
    GP_SHADING_DIFFUSE = 1 /* every surface is Lambertian with its base colour: for comparisons */
} GpShading;

typedef struct GpProgress {
    double fraction;         /* 0..1 of what was asked for */
    double secondsElapsed, secondsRemaining; /* remaining < 0: not known yet */
    uint32_t samplesPerPixel;
    double raysPerSecond;
    double noise;            /* estimated mean absolute error over the mean; < 0: not known */
} GpProgress;

/* Where GP_MODE_LOCAL computes light. */
typedef enum GpShadingFrequency {
    GP_FREQUENCY_PIXEL = 0,   /* Phong shading: the normal is interpolated, light computed for every
                                 sample; the only one that shows normal maps */
    GP_FREQUENCY_VERTEX = 1,  /* Gouraud shading: computed for the corners of each triangle, base
                                 colour included, and interpolated */
    GP_FREQUENCY_TRIANGLE = 2 /* flat shading: once, for its centroid and geometric normal */
} GpShadingFrequency;

/* How the light of lamps (not of directional ones) falls off in GP_MODE_LOCAL. At a distance of one
 * metre all are the same. */
typedef enum GpFalloff {
    GP_FALLOFF_INVERSE_SQUARE = 0, /* as light does */
    GP_FALLOFF_INVERSE = 1,
    GP_FALLOFF_NONE = 2
} GpFalloff;

/* How GP_MODE_LOCAL keeps highlights on curved surfaces from flickering: they are made as wide as
 * the half vector turns within a pixel. Of glTF, GGX (also dielectric) and Beckmann materials,
 * their reflections only; normal maps do not count as curvature. docs/water.md compares them. */
typedef enum GpNdfFilter {
    GP_NDF_FILTER_NONE = 0,
    GP_NDF_FILTER_KAPLANYAN = 1, /* 2016: slopes of the half vector, along tangent and bitangent */
    GP_NDF_FILTER_TOKUYOSHI = 2, /* 2021: the projected half vector, in any direction; the best */
    GP_NDF_FILTER_DEFERRED = 3   /* 2019: one width for all lights, from the normal alone */
} GpNdfFilter;

/* GP_MODE_LOCAL: what the camera sees is lit by the lamps alone, without shadows and bounces, as a
 * rasteriser would; light is f cos E, summed over the lamps. Spheres and rectangles shine from
 * their centre with their whole power, polygons from the centres of their triangles, directional
 * lights as if their angularRadius were 0; but highlights on surfaces of slopes (model `glint`, the
 * sea) are as wide as it makes them.
 * Surfaces that glow show it, but light nothing. The environment is the background, and its mean
 * radiance is added to `ambient` (but see environmentFacets); ambient light times the surface's
 * albedo (GP_IMAGE_ALBEDO) is added too. */
typedef struct GpLocalLighting {
    GpBsdf model;                 /* the reflectance of all surfaces; its base_color, where it has
                                     one, is multiplied by theirs. NULL = each has its own */
    GpShadingFrequency frequency; /* GP_FREQUENCY_PIXEL */
    GpFalloff falloff;            /* GP_FALLOFF_INVERSE_SQUARE */
    float ambient[3];             /* radiance from all sides, W/(m^2 sr), >= 0; 0 */
    GpNdfFilter ndfFilter;        /* GP_NDF_FILTER_NONE; others only with GP_FREQUENCY_PIXEL */
    uint32_t environmentFacets;   /* 0: the environment is ambient light. 9, 16, 25: so many facets
                                     of each surface of slopes (model `glint`, the sea) reflect it,
                                     each a part as wide as it stands for [Dupuy et al. 2013,
                                     LEADR]; other surfaces, and the matte share of these, have
                                     their albedo times its irradiance over pi, by their normal.
                                     Nothing hides it, and glints are smooth in it. Costs up to
                                     25 MB, and milliseconds where the environment is new */
} GpLocalLighting;

/* GP_MODE_REALTIME: one path a pixel and frame. A pixel has a camera ray that goes on through
 * mirrors and smooth glass, a shadow ray to a directional light, one to another light, and one ray
 * by its material, with options.maxBounces (0 = 1, with a sea 2) bounces behind it. Objects are
 * matched with the last frame by the ids of instances, or else by handles; what has moved,
 * also through gpUpdateMesh, leaves motion vectors. Cameras are pinholes here: apertureRadius does
 * not count. Of GpRenderOptions samplesPerPixel, timeLimit, noiseTarget, pixelFilter,
 * pixelFilterRadius and accumulate are for other modes. */
typedef enum GpAntiAliasing {
    GP_AA_TEMPORAL = 0, /* rays move within their pixels, and each picture goes on from the last */
    GP_AA_NONE = 1,     /* rays go through the middle of their pixels */
    GP_AA_JITTER = 2    /* rays move, nothing else: for applications that average frames */
} GpAntiAliasing;

/* What makes a stable picture of noisy channels. */
typedef enum GpDenoiser {
    GP_DENOISER_ASVGF = 0,  /* mean over frames that ends where light changes, then over neighbours
                               by their variance [Schied, Peters and Dachsbacher 2018] */
    GP_DENOISER_SVGF = 1,   /* a mean over frames of fixed length [Schied et al. 2017] */
    GP_DENOISER_ATROUS = 2, /* neighbours only, nothing over frames [Dammertz et al. 2010] */
    GP_DENOISER_NONE = 3,
    GP_DENOISER_BMFR = 4    /* what features of surfaces explain, by blocks [Koskela et al. 2019] */
} GpDenoiser;

/* A number of the denoisers, light reuse or anti-aliasing that is not to have its default:
 * gpDescribeDenoisers lists them. */
typedef struct GpDenoiserParameter {
    const char* name;
    float value;
} GpDenoiserParameter;

/* How a pixel's shadow ray chooses among the lights that are not directional.
 * [Bitterli et al. 2020, "ReSTIR"] */
typedef enum GpLightReuse {
    GP_REUSE_NONE = 0,    /* by expected irradiance, each pixel and frame by itself */
    GP_REUSE_BIASED = 1,  /* with what this and nearby pixels found in the last frame: less noise,
                             somewhat too dark where few pixels see a light */
    GP_REUSE_UNBIASED = 2 /* the same with the right weights: more noise there, and slower */
} GpLightReuse;

/* The exposure follows what the frame shows: the middle tones become a middle grey, and exposureEv
 * is added to that. */
typedef struct GpEyeAdaptation {
    float seconds;      /* until 63 % of the way to another exposure is done; 0 = no adaptation */
    float evMin, evMax; /* of the exposure that is found; both 0 = -10 and 10 */
} GpEyeAdaptation;

typedef struct GpRealtimeOptions {
    int32_t resetHistory;   /* not 0: nothing of earlier frames is used, as after a cut */
    GpAntiAliasing antiAliasing;
    float renderScale;      /* rays along each side of the picture for a pixel: 0.5..1, 0 = 1. Below
                               1 the picture is scaled up over time; a change keeps history */
    int32_t mirrorLimit;    /* reflections and refractions by smooth surfaces before the surface
                               that a pixel shows; 0 = 4, at most 16, GP_NO_BOUNCES = none */
    GpDenoiser denoiser;
    const GpDenoiserParameter* parameters; /* those that are not here have their defaults */
    uint32_t parameterCount;
    GpLightReuse lightReuse;
    float timeStep;         /* seconds since the last frame; 0 = 1/60 */
    GpEyeAdaptation eyeAdaptation;
    GpLightReuse indirectReuse; /* the same for light of surfaces: pixels hand on where their bounce
                               rays arrived and the light that shone there [Ouyang et al. 2021,
                               "ReSTIR GI"]. Light of further bounces, and smooth lobes, are not
                               handed on. A change forgets history */
    uint32_t skyCubeSize;   /* pixels along each side of the cube that GP_DRAW_SKY is drawn into for
                               reflections and light: 16..1024, 0 = 128 */
    int32_t heatMaps;       /* not 0: makes the layers heat_rays and heat_time (gpReadFrameLayer);
                               8 bytes for each pixel of rays, and some time */
} GpRealtimeOptions;

/* Called on the thread of gpRender, a few times a second at most. Return 0 to go on, else the
 * render stops with GP_ERROR_CANCELLED and keeps its samples. */
typedef int (*GpProgressCallback)(void* user, const GpProgress* progress);

typedef struct GpRenderOptions {
    uint32_t samplesPerPixel;  /* to add in this call; 0 = 64, or no limit if one below is set */
    double timeLimit;          /* seconds; 0 = none. At least one sample is always taken */
    double noiseTarget;        /* stop when the estimated relative error falls below; 0 = none */
    int32_t maxBounces;        /* 0 = 16; GP_NO_BOUNCES = light that arrives directly, only */
    uint64_t seed;             /* the same seed gives the same bits on any number of threads */
    GpShading shading;
    GpPixelFilter pixelFilter;
    float pixelFilterRadius;   /* pixels, at most 16; 0 = the filter's own */
    float clamp;               /* 0 = off. Else the largest luminance that one sample's indirect
                                  light may have: less noise, darker, biased */
    int32_t noRussianRoulette; /* not 0: paths end only at maxBounces */
    float exposureEv;          /* DISPLAY is scaled by 2^exposureEv; -100..100 */
    GpTonemap tonemap;
    int32_t accumulate;        /* not 0: add to what the frame holds. Another or a changed scene, or
                                  another camera, is GP_ERROR_INVALID_OPERATION */
    GpProgressCallback progress;
    void* progressUser;
    GpRealtimeOptions realtime; /* for GP_MODE_REALTIME */
    GpLocalLighting local;     /* for GP_MODE_LOCAL, which in turn has no maxBounces, clamp or
                                  noRussianRoulette: GP_ERROR_INVALID_ARGUMENT where set */
    float rayLength;           /* metres, 0 = without end. Every ray ends there, those of camera,
                                  reflections, bounces and shadows: what lies beyond is not seen and
                                  hides nothing, sky is in its place, and lamps that are farther
                                  away light nothing (GP_MODE_LOCAL: only camera rays end) */
    float skyViewerPosition[3];/* GP_VISIBILITY_SKY is seen from here + skyScale * the camera's */
    float skyScale;            /* position. 0 = a sky that does not move with the camera, 1/16 =
                                  one that was built at a sixteenth of its size */
    int32_t hideBackground;    /* not 0: camera rays that meet nothing see black. Environment, sky
                                  geometry and suns light the scene and are seen in mirrors and
                                  through glass, but not behind it: COLOR is then premultiplied by
                                  its alpha, as pictures that are laid over others should be. What
                                  gpDraw draws is seen all the same */
} GpRenderOptions;

#define GP_NO_BOUNCES (-1)

/* Traces `scene` into `frame`. camera NULL = the scene's first, or gpFrameScene's. options NULL =
 * defaults. A scene without any light shows black: see gpSetSky. */
GP_API GpError gpRender(GpFrame frame, GpScene scene, const GpCameraDesc* camera,
                        const GpRenderOptions* options);
/* Ends a running gpRender of this device soon; any thread, also from a signal handler. */
GP_API void gpCancelRender(GpDevice device);
/* DISPLAY anew with another exposure and tone map, without tracing; the overlay that the last
 * gpRender drew is drawn again (gpDraw). */
GP_API GpError gpTonemapFrame(GpFrame frame, float exposureEv, GpTonemap tonemap);
/* Copies an image out. `size` must be at least width * height * bytesPerPixel. */
GP_API GpError gpReadFrameImage(GpFrame frame, GpFrameImage image, void* pixels, size_t size);

typedef struct GpSaveOptions {
    uint32_t layers;      /* bit (1 << GpFrameImage) for each layer beside COLOR; 0 = none. Only for
                             .exr: GP_ERROR_INVALID_ARGUMENT with the others */
    int32_t fullFloat;    /* EXR: not 0 = 32-bit floats, else half. DEPTH and INSTANCE layers, which
                             half floats cannot hold, always make it 32-bit */
    int32_t alpha;        /* PNG: 0 = opaque RGB, as DISPLAY looks: the background is seen, black
                             where there is none. Not 0 = RGBA: coverage, and colours divided by it
                             before the tone map, as PNG wants them; whatever is seen behind the
                             edges of surfaces is in theirs, so render with hideBackground. EXR
                             always has alpha, with premultiplied colours; .hdr never has:
                             GP_ERROR_INVALID_ARGUMENT */
} GpSaveOptions;

/* By the ending of the name: .png (DISPLAY), .exr, .hdr (COLOR). Written under a temporary name
 * and renamed, so that a failure leaves no broken file. options may be NULL. Cost: with alpha, 20
 * bytes a pixel for the time of the call. */
GP_API GpError gpSaveFrame(GpFrame frame, const char* path, const GpSaveOptions* options);

typedef struct GpFrameStatistics {
    uint32_t samplesPerPixel;          /* in the frame now */
    uint64_t cameraRays, bounceRays, shadowRays; /* of the last gpRender */
    double secondsBuild, secondsRender;/* acceleration structures; tracing */
    double noise;                      /* relative error, < 0: too few samples to say */
    uint64_t accelerationBytes;        /* memory of the acceleration structures */
    uint64_t frameBytes;               /* memory of the frame's images */
    float exposureEv;                  /* of the last gpRender, eye adaptation included */
} GpFrameStatistics;

GP_API GpError gpGetFrameStatistics(GpFrame frame, GpFrameStatistics* statistics);

typedef struct GpPassTime {
    const char* name;      /* static */
    double milliseconds;
} GpPassTime;

/* The passes of the last gpRender of a GP_MODE_REALTIME frame in their order. *count receives how
 * many there are; at most `capacity` of them are written to times, which may be NULL if that is 0.
 * Other modes have none. */
GP_API GpError gpGetPassTimes(GpFrame frame, GpPassTime* times, uint32_t capacity,
                              uint32_t* count);

/* Any image that a GP_MODE_REALTIME frame keeps, by name, as RGBA32F of the frame's size: for
 * looking into it. Whole numbers are converted to floats, normals and directions to xyz, `hit` to
 * instance and triangle, `material` to roughness, metallic, flags and mirrors. Images with a pixel
 * for each block of 3 x 3 are enlarged. An unknown name is GP_ERROR_INVALID_ARGUMENT, and the
 * message names the nearest known one; an image that options (reservoirs without light reuse) or
 * scene (`sun` without facets under a sun) do not make is GP_ERROR_INVALID_OPERATION.
 * Heat maps tell what a pixel costs:
 *   heat_rays      rays that were traced for it in this frame. With a renderScale of 1 their sum is
 *                  that of the ray counters of gpGetFrameStatistics
 *   heat_time      microseconds that threads spent on it in the passes that trace and shade, those
 *                  that packets of camera rays share in equal parts; what else the processor did
 *                  meanwhile counts too
 *   heat_variance  R: estimated variance of the luminance of its light before denoising, seen for
 *                  one frame; G, B, A: of direct, indirect and specular light, over albedo
 * The first two are of frames with options.realtime.heatMaps, the last one of frames with a
 * denoiser: else GP_ERROR_INVALID_OPERATION. */
GP_API GpError gpReadFrameLayer(GpFrame frame, const char* name, float* pixels, size_t size);
/* The denoisers by name, and all their parameters with name, default, range, meaning and who looks
 * at them (`used_by`: denoisers, "light reuse", "indirect reuse", "anti-aliasing"), as a JSON text;
 * sizes as in gpDescribeScene. */
GP_API GpError gpDescribeDenoisers(GpDevice device, char* text, size_t size, size_t* needed);
/* Name and meaning of layer `index`, from 0; both static. GP_ERROR_OUT_OF_RANGE behind the last.
 * Needs no device. */
GP_API GpError gpGetFrameLayerInfo(uint32_t index, const char** name, const char** meaning);

/* ----------------------------------------------------------------------- rasterised geometry
 * Triangles that are drawn into the traced picture: sprites, particles, user interfaces. They cast
 * no light and no shadows, and rays do not meet them. */

/* Where to. First all of SKY is drawn, then SCENE, then tone mapping runs, then OVERLAY is drawn;
 * within each in the order of the calls. Each has a depth of its own: SCENE begins with that of the
 * traced picture (GP_IMAGE_DEPTH), the others with nothing but infinitely far away. */
typedef enum GpDrawTarget {
    GP_DRAW_SCENE = 0,   /* into GP_IMAGE_COLOR: linear radiance, hidden by what was traced. The
                            other images keep what was traced. A pixel that shows both a surface and
                            what is behind its edge counts as the surface */
    GP_DRAW_OVERLAY = 1, /* into GP_IMAGE_DISPLAY: sRGB-encoded, over everything. Colours, and
                            8-bit textures of either colour space, are taken as they stand, and
                            blended so; float textures are encoded */
    GP_DRAW_SKY = 2      /* into GP_IMAGE_COLOR, only where camera rays met nothing; pixels at the
                            edges of surfaces get their share. Seen with the camera at the origin,
                            so that what surrounds (0, 0, 0) seems infinitely far away. In frames
                            of GP_MODE_REALTIME what is drawn with GP_VIEW_CAMERA is drawn into a
                            cube too (GpRealtimeOptions.skyCubeSize; viewport does not count
                            there), over environment and sky geometry: that is what mirrors,
                            reflections and bounced light see then, and what lights the scene. In
                            the other modes these see the environment */
} GpDrawTarget;

/* What positions mean. The lens of the camera (apertureRadius) never blurs what is drawn. */
typedef enum GpDrawView {
    GP_VIEW_DEFAULT = 0, /* SCENE and SKY: GP_VIEW_CAMERA; OVERLAY: GP_VIEW_PIXELS */
    GP_VIEW_CAMERA = 1,  /* world space, seen by the camera of gpRender; nothing behind it shows */
    GP_VIEW_PIXELS = 2,  /* x to the right and y down from the viewport's upper left corner, in
                            pixels; depth is z */
    GP_VIEW_MATRIX = 3   /* through viewProjection, clipped as OpenGL does: -w <= x, y, z <= w, +y
                            is up. Depth is w, where the matrix is a perspective (its w must be
                            metres along the view, as it is in every usual one), else z after the
                            matrix */
} GpDrawView;

/* What source (what is drawn) and destination (what is there) are multiplied by before they are
 * added: OpenGL's factors. */
typedef enum GpBlendFactor {
    GP_BLEND_DEFAULT = 0, /* as said beside the field */
    GP_BLEND_ZERO = 1,
    GP_BLEND_ONE = 2,
    GP_BLEND_SRC_COLOR = 3,
    GP_BLEND_ONE_MINUS_SRC_COLOR = 4,
    GP_BLEND_SRC_ALPHA = 5,
    GP_BLEND_ONE_MINUS_SRC_ALPHA = 6,
    GP_BLEND_DST_ALPHA = 7,
    GP_BLEND_ONE_MINUS_DST_ALPHA = 8,
    GP_BLEND_DST_COLOR = 9,
    GP_BLEND_ONE_MINUS_DST_COLOR = 10,
    GP_BLEND_SRC_ALPHA_SATURATE = 11 /* min(source alpha, 1 - destination alpha); 1 for alpha */
} GpBlendFactor;

/* Drawn where this holds for its own depth against the depth that is there. */
typedef enum GpDepthTest {
    GP_DEPTH_DEFAULT = 0, /* SCENE: GP_DEPTH_LESS_OR_EQUAL; the others: GP_DEPTH_ALWAYS */
    GP_DEPTH_NEVER = 1,
    GP_DEPTH_LESS = 2,
    GP_DEPTH_EQUAL = 3,
    GP_DEPTH_LESS_OR_EQUAL = 4,
    GP_DEPTH_GREATER = 5,
    GP_DEPTH_NOT_EQUAL = 6,
    GP_DEPTH_GREATER_OR_EQUAL = 7,
    GP_DEPTH_ALWAYS = 8
} GpDepthTest;

/* A triangle's front is the side from which its corners run counter-clockwise. */
typedef enum GpCull { GP_CULL_NONE = 0, GP_CULL_BACK = 1, GP_CULL_FRONT = 2 } GpCull;

#define GP_GIVEN_DRAW_COLOR 1 /* of GpDrawDesc.given */

/* Strides are in bytes; 0 = tightly packed. What is drawn is color * colors * texture. */
typedef struct GpDrawDesc {
    GpDrawTarget target;         /* GP_DRAW_SCENE */
    uint32_t given;              /* GP_GIVEN_DRAW_COLOR: four zeros in color count */
    uint32_t vertexCount;        /* at most 2^24 */
    const float* positions;      /* finite; required */
    size_t positionStride;
    uint32_t positionComponents; /* 3 (xyz, w is 1) or 4 (xyzw); 0 = 3 */
    const float* texCoords;      /* uv; NULL = zeros */
    size_t texCoordStride;
    const float* colors;         /* RGBA, 0..1e6 (alpha 0..1), interpolated; NULL = white */
    size_t colorStride;
    const uint32_t* indices;     /* three a triangle; NULL = vertices in order */
    uint32_t indexCount;         /* a multiple of 3, at most 2^26; without indices vertexCount is */
    GpTexture texture;           /* NULL = none; read with its own wraps, filters and mipmaps. May
                                    be released after the call */
    float color[4];              /* RGBA, 0..1e6 (alpha 0..1); four zeros = white */
    float alphaThreshold;        /* what has less alpha is not drawn, 0..1; 0 = all is drawn */
    int32_t blend;               /* 0: the source replaces what is there; else by these factors */
    GpBlendFactor blendSource;           /* GP_BLEND_SRC_ALPHA */
    GpBlendFactor blendDestination;      /* GP_BLEND_ONE_MINUS_SRC_ALPHA; not SATURATE */
    GpBlendFactor blendSourceAlpha;      /* for alpha: as blendSource, but GP_BLEND_ONE in the place
                                            of GP_BLEND_SRC_ALPHA, so that coverage adds up */
    GpBlendFactor blendDestinationAlpha; /* for alpha: as blendDestination; not SATURATE */
    GpDepthTest depthTest;       /* GP_DEPTH_DEFAULT */
    int32_t depthWrite;          /* not 0: hides what is drawn behind it later */
    float depthBias;             /* depth * (1 - depthBias) counts, -1..1. Before it is compared,
                                    traced depth is made farther by 1e-4 of itself, so that what
                                    lies in a traced surface shows */
    GpCull cull;                 /* GP_CULL_NONE */
    GpDrawView view;             /* GP_VIEW_DEFAULT */
    float viewProjection[16];    /* GP_VIEW_MATRIX: 4 rows of 4, clip = viewProjection * world */
    float worldFromObject[12];   /* 3 rows of 4; twelve zeros = identity */
    float viewport[4];           /* x, y of the upper left corner, width, height, in pixels, each
                                    within 32768; four zeros = the frame. May reach beyond it */
} GpDrawDesc;

/* Draws with the next gpRender into `frame`, which uses up what was handed over before it, also
 * when it is cancelled; one that fails otherwise leaves it waiting. Everything is copied. At most
 * 65,536 draws with 2^26 vertices and indices in all may wait: GP_ERROR_TOO_LARGE. Alpha of a
 * picture is coverage; it follows from the blend factors as colour does. */
GP_API GpError gpDraw(GpFrame frame, const GpDrawDesc* desc);

/* Immediate mode, as in OpenGL 1: vertices one by one into an object that then fills a GpMeshDesc
 * (geometry that is traced) or a GpDrawDesc (geometry that is drawn). */
typedef enum GpPrimitive {
    GP_TRIANGLES = 0,
    GP_TRIANGLE_STRIP = 1,
    GP_TRIANGLE_FAN = 2,
    GP_QUADS = 3,
    GP_QUAD_STRIP = 4,
    GP_POLYGON = 5 /* convex */
} GpPrimitive;

typedef enum GpShadeModel {
    GP_SHADE_SMOOTH = 0, /* colours are interpolated */
    GP_SHADE_FLAT = 1    /* a triangle or quad has the colour of its last vertex, a polygon that of
                            its first [OpenGL 2.1 specification, section 2.14.7] */
} GpShadeModel;

GP_API GpImmediate gpNewImmediate(GpDevice device);
GP_API GpError gpReleaseImmediate(GpImmediate immediate);
/* Forgets all vertices; colour, normal, texture coordinate and shade model stay. Not between
 * gpBegin and gpEnd, as all calls of this section but the next four: GP_ERROR_INVALID_OPERATION. */
GP_API GpError gpClearImmediate(GpImmediate immediate);
/* What the next vertices have; at first white, (0, 0, 1), (0, 0). Finite; colour: linear RGBA. */
GP_API GpError gpColor4f(GpImmediate immediate, float r, float g, float b, float a);
GP_API GpError gpNormal3f(GpImmediate immediate, float x, float y, float z);
GP_API GpError gpTexCoord2f(GpImmediate immediate, float u, float v);
/* Only between gpBegin and gpEnd. At most 2^24 vertices in all. */
GP_API GpError gpVertex3f(GpImmediate immediate, float x, float y, float z);
GP_API GpError gpShadeModel(GpImmediate immediate, GpShadeModel model);
GP_API GpError gpBegin(GpImmediate immediate, GpPrimitive primitive);
/* Vertices that do not complete a triangle or quad are left out. */
GP_API GpError gpEnd(GpImmediate immediate);
/* Sets counts, strides and the pointers to positions, indices and, where they were set since the
 * object was made, colours, normals, texture coordinates; the other fields stay. The pointers hold
 * until the next call on `immediate`, these two apart. GP_ERROR_INVALID_OPERATION where there is no
 * whole triangle. */
GP_API GpError gpGetImmediateMesh(GpImmediate immediate, GpMeshDesc* desc);
GP_API GpError gpGetImmediateDraw(GpImmediate immediate, GpDrawDesc* desc);

/* ------------------------------------------------------------------------------- image files */

/* Pixels that the library allocated; give them back with gpFreeImage. */
typedef struct GpImage {
    uint32_t width, height;
    float* pixels;       /* RGBA, top row first; 8- and 16-bit files decoded from sRGB to linear */
    int32_t displayReferred; /* not 0: the file was PNG or JPEG, 1 is white */
} GpImage;

/* Reads PNG, JPEG, Radiance HDR or EXR. */
GP_API GpError gpLoadImage(GpDevice device, const char* path, GpImage* image);
/* By the ending of the name: .png (sRGB encoding, clipped to 0..1), .exr (half), .hdr. Only width,
 * height and pixels of `image` count. Alpha is written as it stands, and colours are neither
 * multiplied nor divided by it; a PNG whose alpha is 1 everywhere has RGB only. */
GP_API GpError gpSaveImage(GpDevice device, const char* path, const GpImage* image);
/* Frees and clears; an image of zeros is allowed. */
GP_API void gpFreeImage(GpImage* image);

/* ------------------------------------------------------------------------------- reflectance
 * The models of the library one by one, to look at and to compute with; no scene is needed. */

/* Whose names `model` and `parameters` are. */
typedef enum GpBsdfDialect {
    GP_DIALECT_OWN = 0,  /* ours: gpDescribeBsdfModels */
    GP_DIALECT_WDAS = 1, /* the .brdf files of Disney's BRDF Explorer (wdas/brdf) */
    GP_DIALECT_BBM = 2   /* the BSDF benchmark (bsdfbenchmark/bbm) */
} GpBsdfDialect;

typedef struct GpBsdfParameter {
    const char* name;
    const char* value;   /* "20"; "0.8,0.5,0.3" or one number for a color; "true" or "false"; the
                            name of a choice */
} GpBsdfParameter;

typedef struct GpBsdfDesc {
    const char* model;                 /* required: the name of a model (gpDescribeBsdfModels) or
                                          of a preset (gpDescribePresets), FILE.toml#NAME or
                                          FILE.binary (measured) */
    GpBsdfDialect dialect;             /* GP_DIALECT_OWN */
    const GpBsdfParameter* parameters; /* those that are not here have their defaults */
    uint32_t parameterCount;
} GpBsdfDesc;

typedef struct GpBsdfValue {
    float f[3]; /* 1/sr, without the cosine; 0 below the horizon of opaque surfaces */
    float pdf;  /* 1/sr: how densely wi is sampled for this wo */
} GpBsdfValue;

/* Bits of GpBsdfSample.lobe. */
enum {
    GP_LOBE_DIFFUSE = 1,
    GP_LOBE_GLOSSY = 2,
    GP_LOBE_SPECULAR = 4,    /* narrower than 1e-3: as good as a mirror */
    GP_LOBE_TRANSMISSION = 8 /* wi lies on the other side of the surface */
};

typedef struct GpBsdfSample {
    float wi[3];     /* to the light, unit length; a failed sample is all zeros */
    float pdf;       /* 1/sr */
    float weight[3]; /* f |cos_i| / pdf: its mean is the directional albedo. Of radiance: what is
                        refracted has the factor (index at wo / index at wi)^2 */
    uint32_t lobe;   /* GP_LOBE_ bits */
} GpBsdfSample;

/* The presets as a JSON text: name, title, group and layers, each with model and parameters; sizes
 * as in gpDescribeScene. path NULL: those of the library, else of a TOML file (docs/manual.md). */
GP_API GpError gpDescribePresets(GpDevice device, const char* path, char* text, size_t size,
                                 size_t* needed);
/* All models with their parameters, ranges, defaults and references as a JSON text; sizes as in
 * gpDescribeScene. */
GP_API GpError gpDescribeBsdfModels(GpDevice device, char* text, size_t size, size_t* needed);
/* NULL on failure. An unknown name or a value that cannot be read is GP_ERROR_INVALID_ARGUMENT; the
 * message names model and parameter, and the nearest known name. A value outside of its range is
 * clamped where the model's literature does not allow it: gpDescribeBsdf tells. A measured file is
 * read once, here, and kept (17.5 MB); what is wrong with one is GP_ERROR_FILE_INVALID. */
GP_API GpBsdf gpNewBsdf(GpDevice device, const GpBsdfDesc* desc);
GP_API GpError gpReleaseBsdf(GpBsdf bsdf);
/* Model, values of all parameters, notices (what was clamped) and, of a measured material, the file
 * as a JSON text. */
GP_API GpError gpDescribeBsdf(GpBsdf bsdf, char* text, size_t size, size_t* needed);
/* `count` values, at most 2^26. wi, to the light, and wo, to the viewer, leave the surface, three
 * floats each, of any length but 0; normal +Z, tangent +X. */
GP_API GpError gpEvaluateBsdf(GpBsdf bsdf, size_t count, const float* wi, const float* wo,
                              GpBsdfValue* values);
/* `count` samples, at most 2^26: a direction wi for each wo from three numbers at u, at least 0 and
 * below 1; the first chooses the lobe, the others the direction. Use good random numbers: their
 * errors are the errors of what is computed with the samples. */
GP_API GpError gpSampleBsdf(GpBsdf bsdf, size_t count, const float* wo, const float* u,
                            GpBsdfSample* samples);

#ifdef __cplusplus
}
#endif
#endif
