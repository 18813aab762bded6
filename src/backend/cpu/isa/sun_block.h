// The facets by which up to 16 points reflect a sun, found at once: their numbers lie apart, and
// all is inlined, so that the compiler makes vectors of the loop. Part of the hot code of local
// lighting, included inside an unnamed namespace.

struct SunBlock {
    static constexpr uint32_t most = 16;

    uint32_t pixels[most];
    uint32_t count = 0;
    // Of view and light, of the material's slopes, its kernel; also where there is no point.
    float woX[most]{}, woY[most]{}, woZ[most]{}, wiX[most]{}, wiY[most]{}, wiZ[most]{};
    float meanX[most]{}, meanY[most]{}, varX[most]{}, varY[most]{}, cov[most]{};
    float kernel[4][most]{};
    // Of the facets.
    float wider[4][most];
    float slopeX[most], slopeY[most], fCos[most], pdf[most], cosH[most];

    void add(uint32_t pixel, const BsdfParams& m, vec3 wo, vec3 wi) {
        const Slopes d = glint_material_slopes(m);
        const uint32_t i = count++;
        pixels[i] = pixel;
        woX[i] = wo.x, woY[i] = wo.y, woZ[i] = wo.z;
        wiX[i] = wi.x, wiY[i] = wi.y, wiZ[i] = wi.z;
        meanX[i] = d.mean.x, meanY[i] = d.mean.y;
        varX[i] = d.var_x, varY[i] = d.var_y, cov[i] = d.cov;
        for (int k = 0; k < 4; ++k) kernel[k][i] = m.slot_e[k];
    }

    vec3 wo(uint32_t i) const { return {woX[i], woY[i], woZ[i]}; }
    vec3 wi(uint32_t i) const { return {wiX[i], wiY[i], wiZ[i]}; }

    SunFacets facets(uint32_t i) const {
        SunFacets s;
        s.kernel = vec4(wider[0][i], wider[1][i], wider[2][i], wider[3][i]);
        s.facet = {vec2(slopeX[i], slopeY[i]), fCos[i], pdf[i], cosH[i], 0.0f};
        return s;
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
