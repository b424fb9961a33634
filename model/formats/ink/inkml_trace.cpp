#include "model/formats/ink/inkml_trace.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace suffuse {

namespace {

constexpr double largestInTrace = 1e15;
constexpr std::size_t mostInTrace = std::size_t(1) << 23; ///< channels may lack in the text, and are kept all the same
constexpr std::string_view blanks = " \t\r\n";

enum class ValueForm { Plain, Difference, Second };

/// What is known of a channel.
struct ChannelState {
    ValueForm form = ValueForm::Plain;
    double value = 0, step = 0;
};

class TraceText {
public:
    explicit TraceText(std::string_view text) : m_rest(text) {}

    /// Whether a point ends here, or all of them.
    bool endsPoint()
    {
        skipBlanks();
        return m_rest.empty() || m_rest.front() == ',';
    }
    bool isOver()
    {
        skipBlanks();
        return m_rest.empty();
    }
    void passComma()
    {
        if (!m_rest.empty())
            m_rest.remove_prefix(1);
    }

    /// Takes one value; false if there is none.
    bool take(ChannelState &channel)
    {
        skipBlanks();
        if (m_rest.empty())
            return false;
        switch (m_rest.front()) {
        case '!':
            channel.form = ValueForm::Plain;
            break;
        case '\'':
            channel.form = ValueForm::Difference;
            break;
        case '"':
            channel.form = ValueForm::Second;
            break;
        default:
            return takeValue(channel);
        }
        m_rest.remove_prefix(1);
        skipBlanks();
        return takeValue(channel);
    }

private:
    void skipBlanks() { m_rest.remove_prefix(std::min(m_rest.find_first_not_of(blanks), m_rest.size())); }

    bool takeValue(ChannelState &channel)
    {
        if (m_rest.empty())
            return false;
        if (m_rest.front() == '*' || m_rest.front() == '?') { // as before, or not known
            m_rest.remove_prefix(1);
            return true;
        }
        if (m_rest.front() == 'T' || m_rest.front() == 'F') {
            channel.value = m_rest.front() == 'T' ? 1 : 0;
            m_rest.remove_prefix(1);
            return true;
        }
        const std::optional<double> number = takeNumber();
        if (!number)
            return false;
        if (channel.form == ValueForm::Plain) {
            channel.step = *number - channel.value;
        } else {
            channel.step = channel.form == ValueForm::Difference ? *number : channel.step + *number;
        }
        channel.value = channel.form == ValueForm::Plain ? *number : channel.value + channel.step;
        return std::abs(channel.value) <= largestInTrace && std::abs(channel.step) <= 2 * largestInTrace;
    }

    std::optional<double> takeNumber()
    {
        if (m_rest.front() == '+')
            m_rest.remove_prefix(1);
        double value = 0;
        std::from_chars_result read{};
        if (m_rest.starts_with('#')) { // base 16
            long long whole = 0;
            read = std::from_chars(m_rest.data() + 1, m_rest.data() + m_rest.size(), whole, 16);
            value = double(whole);
        } else {
            read = std::from_chars(m_rest.data(), m_rest.data() + m_rest.size(), value);
        }
        if (read.ec != std::errc() || !std::isfinite(value))
            return std::nullopt;
        m_rest.remove_prefix(std::size_t(read.ptr - m_rest.data()));
        return value;
    }

    std::string_view m_rest;
};

} // namespace

std::optional<std::vector<double>> traceValues(std::string_view text, std::size_t channels, std::size_t optional,
                                               std::size_t most)
{
    std::vector<double> values;
    std::vector<ChannelState> states(channels);
    TraceText trace(text);
    while (!trace.isOver()) {
        std::size_t k = 0;
        for (; k < channels && !(k > 0 && trace.endsPoint()); ++k)
            if (!trace.take(states[k]))
                return std::nullopt;
        if (k + optional < channels || !trace.endsPoint() || values.size() >= std::min(channels * most, mostInTrace))
            return std::nullopt;
        for (const ChannelState &state : states)
            values.push_back(state.value);
        trace.passComma();
    }
    return values;
}

} // namespace suffuse
