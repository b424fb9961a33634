#include "model/formats/suffuse/fill_columns.h"

#include "model/formats/suffuse/suffuse_predict.h"

namespace suffuse {

void FillColumns::add(const Stroke &stroke)
{
    if (!stroke.fill) {
        m_marks.push_back(0);
        return;
    }
    const Fill &fill = *stroke.fill;
    m_marks.push_back(
        std::uint8_t(IsFilled | (fill.rule == FillRule::EvenOdd ? IsEvenOdd : 0) | (fill.gradient ? HasGradient : 0)));
    m_numbers.add(fill);
    m_born.push_back(zigzag64(std::uint64_t(fill.born) - std::uint64_t(stroke.segments.front().born)));
    if (!fill.gradient)
        return;
    const Gradient &gradient = *fill.gradient;
    const std::array<float, 4> ends{gradient.from.x, gradient.from.y, gradient.to.x, gradient.to.y};
    for (std::size_t k = 0; k < ends.size(); ++k)
        m_ends[k].push_back(std::bit_cast<std::uint32_t>(ends[k]));
    m_gradientNumbers.add(gradient);
}

void FillColumns::put(ColumnWriter &out) const
{
    out.put(m_marks);
    m_numbers.put(out);
    out.put(m_born);
    for (const auto &end : m_ends)
        out.put(end);
    m_gradientNumbers.put(out);
}

bool FillColumns::get(ColumnReader &in, std::size_t strokes)
{
    m_marks = in.get<std::uint8_t>(strokes);
    const auto allowed = [](std::uint8_t mark) {
        return mark == 0 || ((mark & IsFilled) && mark <= (IsFilled | IsEvenOdd | HasGradient));
    };
    if (!std::ranges::all_of(m_marks, allowed))
        return false;
    const auto count = [&](Mark mark) {
        return std::size_t(std::ranges::count_if(m_marks, [mark](std::uint8_t m) { return m & mark; }));
    };
    m_numbers.get(in, count(IsFilled));
    m_born = in.get<std::uint64_t>(count(IsFilled));
    for (auto &end : m_ends)
        end = in.get<std::uint32_t>(count(HasGradient));
    m_gradientNumbers.get(in, count(HasGradient));
    return in.ok();
}

void FillColumns::set(Stroke &stroke, std::size_t place)
{
    if (m_marks.empty() || !m_marks[place])
        return;
    Fill fill;
    m_numbers.set(fill, m_fill);
    fill.born = Microseconds(std::uint64_t(stroke.segments.front().born) + unzigzag64(m_born[m_fill]));
    fill.rule = m_marks[place] & IsEvenOdd ? FillRule::EvenOdd : FillRule::NonZero;
    ++m_fill;
    if (m_marks[place] & HasGradient) {
        Gradient &gradient = fill.gradient.emplace();
        const auto end = [&](std::size_t k) { return std::bit_cast<float>(m_ends[k][m_gradient]); };
        gradient.from = {end(0), end(1)};
        gradient.to = {end(2), end(3)};
        m_gradientNumbers.set(gradient, m_gradient);
        ++m_gradient;
    }
    stroke.fill = fill;
}

} // namespace suffuse
