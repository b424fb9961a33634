#include "model/formats/pdf/module_bounds.h"

#include <qpdf/Pl_Flate.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFStreamFilter.hh>

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace suffuse {

namespace {

thread_local std::size_t mostUnpacked = std::numeric_limits<std::size_t>::max();

class Counted : public Pipeline {
public:
    explicit Counted(Pipeline *next) : Pipeline("counted", next) {}

    void write(const unsigned char *bytes, std::size_t size) override
    {
        m_size += size;
        if (m_size > mostUnpacked)
            throw std::runtime_error("a part of it would be too large unpacked");
        getNext()->write(bytes, size);
    }
    void finish() override { getNext()->finish(); }

private:
    std::size_t m_size = 0;
};

/// Undoes the predictors of PNG, in which a row is told by what it differs from its neighbours.
class Rows : public Pipeline {
public:
    Rows(Pipeline *next, std::size_t pixel, std::size_t row)
        : Pipeline("rows", next), m_pixel(pixel), m_above(row + pixel), m_row(row + pixel)
    {}

    void write(const unsigned char *bytes, std::size_t size) override
    {
        for (std::size_t i = 0; i < size; ++i) {
            if (m_at == 0) {
                m_kind = bytes[i];
                m_at = m_pixel; // Left of a row all is 0.
                continue;
            }
            m_row[m_at] = std::uint8_t(bytes[i] + predicted());
            if (++m_at == m_row.size())
                put();
        }
    }
    void finish() override
    {
        if (m_at > m_pixel)
            put();
        getNext()->finish();
    }

private:
    int predicted() const
    {
        const int left = m_row[m_at - m_pixel], above = m_above[m_at], corner = m_above[m_at - m_pixel];
        switch (m_kind) {
        case 1:
            return left;
        case 2:
            return above;
        case 3:
            return (left + above) / 2;
        case 4: {
            const int sum = left + above - corner;
            const int a = std::abs(sum - left), b = std::abs(sum - above), c = std::abs(sum - corner);
            return a <= b && a <= c ? left : (b <= c ? above : corner);
        }
        default:
            return 0;
        }
    }
    void put()
    {
        getNext()->write(m_row.data() + m_pixel, m_at - m_pixel);
        m_above = m_row;
        m_at = 0;
    }

    std::size_t m_pixel, m_at = 0;
    int m_kind = 0;
    std::vector<std::uint8_t> m_above, m_row; ///< after a pixel of zeros
};

/// /FlateDecode.
class Flate : public QPDFStreamFilter {
public:
    bool setDecodeParms(QPDFObjectHandle parameters) override
    {
        if (parameters.isNull())
            return true;
        if (!parameters.isDictionary())
            return false;
        const auto number = [&](const char *key, long long otherwise) {
            QPDFObjectHandle value = parameters.getKey(key);
            return value.isInteger() ? value.getIntValue() : otherwise;
        };
        const long long predictor = number("/Predictor", 1), columns = number("/Columns", 1),
                        colours = number("/Colors", 1), bits = number("/BitsPerComponent", 8);
        if (predictor <= 1)
            return true;
        constexpr long long mostColumns = 1 << 24, mostColours = 32, mostBits = 16;
        if (predictor < 10 || columns < 1 || columns > mostColumns || colours < 1 || colours > mostColours ||
            bits < 1 || bits > mostBits)
            return false;
        m_pixel = std::size_t((colours * bits + 7) / 8);
        m_row = std::size_t((columns * colours * bits + 7) / 8);
        return true;
    }
    Pipeline *getDecodePipeline(Pipeline *next) override
    {
        if (m_row > 0)
            next = keep(new Rows(next, m_pixel, m_row));
        next = keep(new Counted(next));
        return keep(new Pl_Flate("flate", next, Pl_Flate::a_inflate));
    }

private:
    Pipeline *keep(Pipeline *pipeline)
    {
        m_pipelines.emplace_back(pipeline);
        return pipeline;
    }

    std::size_t m_pixel = 0, m_row = 0;
    std::vector<std::unique_ptr<Pipeline>> m_pipelines;
};

/// What no file of ours has, and nobody needs for what is attached.
class Refused : public QPDFStreamFilter {
public:
    bool setDecodeParms(QPDFObjectHandle) override { return false; }
    Pipeline *getDecodePipeline(Pipeline *) override { return nullptr; }
};

} // namespace

UnpackedBound::UnpackedBound(std::size_t most)
{
    static const bool isRegistered = [] {
        QPDF::registerStreamFilter("/FlateDecode", [] { return std::make_shared<Flate>(); });
        QPDF::registerStreamFilter("/LZWDecode", [] { return std::make_shared<Refused>(); });
        return true;
    }();
    if (isRegistered)
        mostUnpacked = most;
}

UnpackedBound::~UnpackedBound()
{
    mostUnpacked = std::numeric_limits<std::size_t>::max();
}

} // namespace suffuse
