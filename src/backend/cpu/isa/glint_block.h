// Up to 16 points of the glint model, their albedo, the facets by which they reflect a sun, and
// what these reflect: numbers lie apart, and all is inlined, so that the compiler makes vectors of
// the loops. Part of the hot code of local lighting, included inside an unnamed namespace.

// What is known of the points; nothing but arrays of four bytes for each of them (pad).
struct GlintPoints {
    static constexpr uint32_t most = 16;
    typedef float Numbers[most];

    // The view in the point's frame, and the way to a sun.
    Numbers woX, woY, woZ, wiX, wiY, wiZ{};
    // What the model has of slopes and glints.
    Numbers alphaX{}, alphaY{}, meanX{}, meanY{}, correlation{}, kernel[4]{};
    Numbers density{}, area{}, jitter{}, seed{}, u{}, v{}, sides[4]{};
    uint32_t tableLow[most]{}, tableHigh[most]{};
    // Its colours.
    Numbers base[3]{}, specularColor[3]{}, specular{}, metallic{}, transmission{}, ior{}, lost{};
    Numbers reflected[12]{}, through{};
    uint32_t thin[most]{};
};

struct GlintBlock : GlintPoints {
    // One of the two levels of a GlintLookup, with its ellipse.
    struct Level {
        uint32_t shift[most];
        Numbers facets, occupied, share;
        Numbers x, y, skew, width2, inverseWidth2, inverseHeight2;
        int first[most], last[most];
    };

    uint32_t pixels[most];
    uint32_t count = 0;
    bool hasDictionary = false;  // of glints, any of them

    // What is found of it.
    Numbers albedo[3];
    Numbers wider[4];
    Numbers slopeX, slopeY, fCos, pdf, cosH;
    Numbers facetShare[3], matteShare[3];
    Numbers whiteX, whiteY, kernel0X, kernel0Y, kernel1X, kernel1Y, scale, gaussian;
    Level low, high;
    Numbers highShare, spread, alone;

    void add(uint32_t pixel, const BsdfParams& m, vec3 wo) {
        const uint32_t i = count++;
        pixels[i] = pixel;
        wiX[i] = wiY[i] = wiZ[i] = 0.0f;
        hasDictionary |= glint_method(m) == GLINT_DICTIONARY;
        woX[i] = wo.x, woY[i] = wo.y, woZ[i] = wo.z;
        alphaX[i] = m.alpha_x, alphaY[i] = m.alpha_y;
        meanX[i] = m.slot_a.x, meanY[i] = m.slot_a.y, correlation[i] = m.slot_a.z;
        density[i] = m.slot_a.w, area[i] = m.slot_b.y, jitter[i] = m.slot_b.z;
        seed[i] = m.slot_c.z, u[i] = m.slot_c.x, v[i] = m.slot_c.y;
        tableLow[i] = m.table.x, tableHigh[i] = m.table.y;
        for (int k = 0; k < 4; ++k) {
            kernel[k][i] = m.slot_e[k];
            sides[k][i] = m.slot_d[k];
            reflected[k][i] = m.slot_g[k];
            reflected[4 + k][i] = m.slot_h[k];
            reflected[8 + k][i] = m.slot_i[k];
        }
        for (int k = 0; k < 3; ++k) {
            base[k][i] = m.base_color[k];
            specularColor[k][i] = m.specular_color[k];
        }
        specular[i] = m.specular, metallic[i] = m.metallic, transmission[i] = m.transmission;
        ior[i] = m.ior, lost[i] = m.slot_c.w, through[i] = m.slot_j.x, thin[i] = m.thin;
    }

    // Where there is no point the last one stands again.
    void pad() {
        GlintPoints& points = *this;
        char* bytes = reinterpret_cast<char*>(&points);
        for (size_t row = 0; row < sizeof(points); row += sizeof(Numbers))
            for (uint32_t i = count; i < most; ++i)
                __builtin_memcpy(bytes + row + 4 * i, bytes + row + 4 * (count - 1), 4);
    }

    void setSun(uint32_t i, vec3 wi) { wiX[i] = wi.x, wiY[i] = wi.y, wiZ[i] = wi.z; }

    vec3 wo(uint32_t i) const { return {woX[i], woY[i], woZ[i]}; }
    vec3 wi(uint32_t i) const { return {wiX[i], wiY[i], wiZ[i]}; }

    // What sun_facets and sun_lookup ask of the model.
    BsdfParams glints(uint32_t i) const {
        BsdfParams m;
        m.alpha_x = alphaX[i], m.alpha_y = alphaY[i];
        m.slot_a = vec4(meanX[i], meanY[i], correlation[i], density[i]);
        m.slot_b = vec4(0.0f, area[i], jitter[i], 0.0f);
        m.slot_c = vec4(u[i], v[i], seed[i], 0.0f);
        m.slot_d = vec4(sides[0][i], sides[1][i], sides[2][i], sides[3][i]);
        m.slot_e = vec4(kernel[0][i], kernel[1][i], kernel[2][i], kernel[3][i]);
        m.table = uvec2(tableLow[i], tableHigh[i]);
        return m;
    }

    // What sun_shares and glint_front_albedo ask of it, without layers and film.
    BsdfParams colours(uint32_t i) const {
        BsdfParams m;
        m.base_color = vec3(base[0][i], base[1][i], base[2][i]);
        m.specular_color = vec3(specularColor[0][i], specularColor[1][i], specularColor[2][i]);
        m.specular = specular[i], m.metallic = metallic[i], m.transmission = transmission[i];
        m.ior = ior[i], m.thin = thin[i], m.iridescence = 0.0f;
        m.alpha_x = alphaX[i], m.alpha_y = alphaY[i];
        m.slot_a = vec4(meanX[i], meanY[i], 0.0f, 0.0f);
        m.slot_c = vec4(0.0f, 0.0f, 0.0f, lost[i]);
        const auto four = [&](int k) {
            return vec4(reflected[k][i], reflected[k + 1][i], reflected[k + 2][i],
                        reflected[k + 3][i]);
        };
        m.slot_g = four(0), m.slot_h = four(4), m.slot_i = four(8);
        m.slot_j = vec4(through[i], 0.0f, 0.0f, 0.0f);
        return m;
    }

    SunFacets facets(uint32_t i) const {
        SunFacets s;
        s.kernel = vec4(wider[0][i], wider[1][i], wider[2][i], wider[3][i]);
        s.facet = {vec2(slopeX[i], slopeY[i]), fCos[i], pdf[i], cosH[i], 0.0f};
        return s;
    }

    void setLevel(Level& n, uint32_t i, const GlintLevel& l, const Ellipse& e) {
        n.shift[i] = l.shift;
        n.facets[i] = l.facets, n.occupied[i] = l.occupied, n.share[i] = l.share;
        n.x[i] = e.centre.x, n.y[i] = e.centre.y, n.skew[i] = e.skew;
        n.width2[i] = e.width2, n.inverseWidth2[i] = e.inv_width2;
        n.inverseHeight2[i] = e.inv_height2;
        n.first[i] = e.first, n.last[i] = e.last;
    }
    void setLookup(uint32_t i, const GlintLookup& l) {
        const GlintQuery& q = l.query;
        whiteX[i] = q.slope.x, whiteY[i] = q.slope.y;
        kernel0X[i] = q.k0.x, kernel0Y[i] = q.k0.y, kernel1X[i] = q.k1.x, kernel1Y[i] = q.k1.y;
        scale[i] = q.scale, gaussian[i] = q.gaussian;
        setLevel(low, i, l.steps.low, l.steps.low_cells);
        setLevel(high, i, l.steps.high, l.steps.high_cells);
        highShare[i] = l.steps.share, spread[i] = l.steps.low.spread, alone[i] = l.alone;
    }

    GlintLevel level(const Level& n, uint32_t i) const {
        return {n.shift[i], n.facets[i], spread[i], n.occupied[i], n.share[i], uint(seed[i])};
    }
    static Ellipse cells(const Level& n, uint32_t i) {
        return {vec2(n.x[i], n.y[i]), n.skew[i], n.width2[i], n.inverseWidth2[i],
                n.inverseHeight2[i], n.first[i], n.last[i]};
    }
    GlintLookup lookup(uint32_t i) const {
        GlintLookup l;
        l.query = {uvec2(tableLow[i], tableHigh[i]), vec2(whiteX[i], whiteY[i]),
                   vec2(kernel0X[i], kernel0Y[i]), vec2(kernel1X[i], kernel1Y[i]), scale[i],
                   gaussian[i]};
        l.steps = {level(low, i), level(high, i), cells(low, i), cells(high, i), highShare[i]};
        l.alone = alone[i];
        return l;
    }
};

// Of points without layers and film (has_sun_shares). The block is full, or padded.
[[gnu::flatten]] inline void findAlbedos(GlintBlock& b) {
    for (uint32_t i = 0; i < GlintBlock::most; ++i) {
        const BsdfParams m = b.colours(i);
        const vec3 albedo =
            glint_front_albedo(m, std::abs(mesosurface_cosine(glint_mean(m), b.wo(i))));
        for (int k = 0; k < 3; ++k) b.albedo[k][i] = albedo[k];
    }
}

// masking: a GLINT_MASKING_, of all of them.
template <uint masking>
[[gnu::flatten]] void findFacets(GlintBlock& b, float sinRadius) {
    for (uint32_t i = 0; i < GlintBlock::most; ++i) {
        const BsdfParams m = b.glints(i);
        const SunFacets s = sun_facets(glint_material_slopes(m), m.slot_e, masking, b.wo(i),
                                       b.wi(i), sinRadius);
        b.wider[0][i] = s.kernel.x, b.wider[1][i] = s.kernel.y;
        b.wider[2][i] = s.kernel.z, b.wider[3][i] = s.kernel.w;
        b.slopeX[i] = s.facet.slope.x, b.slopeY[i] = s.facet.slope.y;
        b.fCos[i] = s.facet.f_cos, b.pdf[i] = s.facet.pdf, b.cosH[i] = s.facet.cos_h;
    }
}

// Of the facets found. What points with layers have of it means nothing.
[[gnu::flatten]] inline void findShares(GlintBlock& b) {
    for (uint32_t i = 0; i < GlintBlock::most; ++i) {
        const SunShares s = sun_shares(b.colours(i), b.facets(i).facet, b.wo(i), b.wi(i));
        for (int k = 0; k < 3; ++k) {
            b.facetShare[k][i] = s.facets[k];
            b.matteShare[k][i] = s.matte[k];
        }
    }
}

// How the facets found are looked up in the dictionary, of those that have it.
[[gnu::flatten]] inline void findLookups(GlintBlock& b) {
    if (!b.hasDictionary) return;
    for (uint32_t i = 0; i < GlintBlock::most; ++i)
        b.setLookup(i, sun_lookup(b.glints(i), b.facets(i)));
}

// All of that, for points before which the sun stands; masking: of all of them.
template <uint masking>
void findSun(GlintBlock& b, const DirectionalLight& sun) {
    findFacets<masking>(b, std::sqrt(sun_sin_squared(sun)));
    findShares(b);
    findLookups(b);
}

// f cos of point i, whose material m is: as sun_facets_f_cos.
inline vec3 sunFCos(const GlintBlock& b, uint32_t i, const BsdfParams& m,
                    const DirectionalLight& sun) {
    const vec3 wo = b.wo(i), wi = b.wi(i);
    if (!has_sun_shares(m)) return sun_facets_f_cos(m, b.facets(i), wo, wi, sun);
    const vec3 facets(b.facetShare[0][i], b.facetShare[1][i], b.facetShare[2][i]);
    const vec3 matte(b.matteShare[0][i], b.matteShare[1][i], b.matteShare[2][i]);
    const float density = glint_method(m) == GLINT_DICTIONARY
                              ? glint_looked_up(b.lookup(i))
                              : sun_facet_density(m, b.facets(i), wo, wi, sun);
    return matte + facets * density;
}
