// The facets by which up to 16 points reflect a sun, and what these reflect, found at once: their
// numbers lie apart, and all is inlined, so that the compiler makes vectors of the loops. Part of
// the hot code of local lighting, included inside an unnamed namespace.

struct SunBlock {
    static constexpr uint32_t most = 16;
    typedef float Numbers[most];

    uint32_t pixels[most];
    uint32_t count = 0;
    // Also where there is no point: view and light, the material's slopes, its kernel.
    Numbers woX{}, woY{}, woZ{}, wiX{}, wiY{}, wiZ{};
    Numbers meanX{}, meanY{}, varX{}, varY{}, cov{};
    Numbers kernel[4]{};
    // Its colours.
    Numbers base[3]{}, specularColor[3]{}, specular{}, metallic{}, transmission{}, ior{}, lost{};
    Numbers reflected[12]{}, through{};
    uint32_t thin[most]{};
    // Of the facets.
    Numbers wider[4];
    Numbers slopeX, slopeY, fCos, pdf, cosH;
    Numbers facetShare[3], matteShare[3];

    void add(uint32_t pixel, const BsdfParams& m, vec3 wo, vec3 wi) {
        const Slopes d = glint_material_slopes(m);
        const uint32_t i = count++;
        pixels[i] = pixel;
        woX[i] = wo.x, woY[i] = wo.y, woZ[i] = wo.z;
        wiX[i] = wi.x, wiY[i] = wi.y, wiZ[i] = wi.z;
        meanX[i] = d.mean.x, meanY[i] = d.mean.y;
        varX[i] = d.var_x, varY[i] = d.var_y, cov[i] = d.cov;
        for (int k = 0; k < 4; ++k) {
            kernel[k][i] = m.slot_e[k];
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

    vec3 wo(uint32_t i) const { return {woX[i], woY[i], woZ[i]}; }
    vec3 wi(uint32_t i) const { return {wiX[i], wiY[i], wiZ[i]}; }

    SunFacets facets(uint32_t i) const {
        SunFacets s;
        s.kernel = vec4(wider[0][i], wider[1][i], wider[2][i], wider[3][i]);
        s.facet = {vec2(slopeX[i], slopeY[i]), fCos[i], pdf[i], cosH[i], 0.0f};
        return s;
    }

    // What sun_shares asks of a material, without layers and film.
    BsdfParams colours(uint32_t i) const {
        BsdfParams m;
        m.base_color = vec3(base[0][i], base[1][i], base[2][i]);
        m.specular_color = vec3(specularColor[0][i], specularColor[1][i], specularColor[2][i]);
        m.specular = specular[i], m.metallic = metallic[i], m.transmission = transmission[i];
        m.ior = ior[i], m.thin = thin[i], m.iridescence = 0.0f;
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

    SunShares shares(uint32_t i) const {
        return {vec3(facetShare[0][i], facetShare[1][i], facetShare[2][i]),
                vec3(matteShare[0][i], matteShare[1][i], matteShare[2][i])};
    }
};

// masking: a GLINT_MASKING_, of all of them.
template <uint masking>
[[gnu::flatten]] void findFacets(SunBlock& b, float sinRadius) {
    for (uint32_t i = 0; i < SunBlock::most; ++i) {
        Slopes d;
        d.mean = vec2(b.meanX[i], b.meanY[i]);
        d.var_x = b.varX[i], d.var_y = b.varY[i], d.cov = b.cov[i];
        const vec4 kernel(b.kernel[0][i], b.kernel[1][i], b.kernel[2][i], b.kernel[3][i]);
        const SunFacets s = sun_facets(d, kernel, masking, b.wo(i), b.wi(i), sinRadius);
        b.wider[0][i] = s.kernel.x, b.wider[1][i] = s.kernel.y;
        b.wider[2][i] = s.kernel.z, b.wider[3][i] = s.kernel.w;
        b.slopeX[i] = s.facet.slope.x, b.slopeY[i] = s.facet.slope.y;
        b.fCos[i] = s.facet.f_cos, b.pdf[i] = s.facet.pdf, b.cosH[i] = s.facet.cos_h;
    }
}

// Of the facets found. What points with layers have of it means nothing.
[[gnu::flatten]] inline void findShares(SunBlock& b) {
    for (uint32_t i = 0; i < SunBlock::most; ++i) {
        const SunShares s = sun_shares(b.colours(i), b.facets(i).facet, b.wo(i), b.wi(i));
        for (int k = 0; k < 3; ++k) {
            b.facetShare[k][i] = s.facets[k];
            b.matteShare[k][i] = s.matte[k];
        }
    }
}
