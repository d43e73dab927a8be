// Adding to the tables of a Program.
// SPDX-License-Identifier: MIT
#include "load/builder.h"

#include "core/number.h"
#include "core/ports.h"
#include "load/expression.h"
#include "load/forms.h"
#include "load/text.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <utility>

namespace trellis {

namespace {

/// Rows nest at most this deep: the interpreter's recursion stays within a small stack.
constexpr std::uint32_t max_row_depth = 1024;

}  // namespace

void Builder::reserve(std::size_t rows) {
    program.rows.reserve(rows);
    program.names.by_row.reserve(rows);
    program.origins.reserve(rows);
    program.calls.reserve(rows);
    depths_.reserve(rows);
}

std::uint32_t Builder::name_index(std::string_view name) {
    const auto next = static_cast<std::uint32_t>(program.names.texts.size());
    const auto [found, fresh] = name_index_.try_emplace(std::string(name), next);
    if (fresh) { program.names.texts.emplace_back(name); }
    return found->second;
}

RowId Builder::open(Op op, RowId parent, std::string_view name, Where where, std::uint32_t arg) {
    const std::uint32_t depth = parent ? depths_[parent.index] + 1 : 0;
    const RowId n{next_row()};
    if (full_ || n.index >= options_.rows || depth > max_row_depth) {
        if (!full_) {
            diagnostics_.error("program-size", where,
                               depth > max_row_depth
                                   ? "nodes nest deeper than " + std::to_string(max_row_depth) +
                                         " once subtrees are expanded"
                                   : "more than " + std::to_string(options_.rows) +
                                         " nodes once subtrees are expanded");
        }
        full_ = true;
        return {};
    }
    RowId scope = parent;
    if (parent) {
        const Row& around = program.at(parent);
        const bool is_scope =
            around.op == Op::tree || around.op == Op::subtree || around.op == Op::machine;
        scope = is_scope ? parent : around.scope;
    }
    program.rows.push_back(
        {.op = op, .parent = parent, .scope = scope, .end = {n.index + 1}, .arg = arg});
    program.names.by_row.push_back(name_index(name));
    program.origins.push_back({where.file, where.line, where.column});
    depths_.push_back(depth);
    return n;
}

SlotId Builder::add_slot(std::string_view name, RowId scope) {
    const SlotId slot{static_cast<std::uint32_t>(program.slots.size())};
    program.slots.push_back({.name = std::string(name), .scope = scope, .initial = {}});
    return slot;
}

void Builder::set_initial(SlotId slot, Value value) {
    Slot& variable = program.slots[slot.index];
    variable.type = value.is(Value::Kind::integer) ? EntryType::integer
                    : value.is(Value::Kind::real)  ? EntryType::real
                    : value.is(Value::Kind::text)  ? EntryType::text
                                                   : EntryType::any;
    variable.initial = std::move(value);
}

Meaning Builder::sensor(std::string_view name) {
    const HostType& host = registry_.host();
    const Sensor* sensor = host.find(name);
    if (sensor == nullptr) {
        std::vector<std::string_view> known;
        for (const Sensor& other : host.sensors) {
            known.emplace_back(other.name);
        }
        return {.kind = Meaning::Kind::error,
                .value = {},
                .message = "the robot has no sensor \"" + std::string(name) + "\"" +
                           suggestion(name, known)};
    }
    program.host = &host;
    const Meaning::Kind kind = sensor->type == PortType::boolean ? Meaning::Kind::sensor_boolean
                               : sensor->type == PortType::real  ? Meaning::Kind::sensor_real
                                                                 : Meaning::Kind::sensor_integer;
    return {.kind = kind, .index = sensor->offset, .value = {}, .message = {}};
}

void Builder::name_enumerators() {
    std::vector<EnumValue>& enums = program.code.enums;
    for (const auto& [name, number] : registry_.enumerators()) {
        enums.push_back({name, static_cast<double>(number)});
    }
    std::sort(enums.begin(), enums.end(),
              [](const EnumValue& a, const EnumValue& b) { return a.name < b.name; });
}

const std::int64_t* Builder::enumerator(std::string_view name) const {
    for (const auto& [known, number] : registry_.enumerators()) {
        if (known == name) { return &number; }
    }
    return nullptr;
}

Value Builder::enumerated(std::string_view literal) const {
    const std::int64_t* const number = enumerator(literal);
    return number != nullptr ? Value::integer(*number) : literal_value(literal);
}

// Code --------------------------------------------------------------------------------------------

namespace {

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

Where Builder::place_in(const Text& text, std::size_t offset) const {
    if (diagnostics_.is_full()) { return text.where; }  // to find it takes long; nobody will see it
    return where_in(diagnostics_.file_text(text.where.file), text.file->document.spelling,
                    text.where, offset);
}

Where Builder::place_of(const Text& text, std::string_view name) const {
    const std::string_view all = text.text;
    for (std::size_t at = all.find(name); at != std::string_view::npos;
         at = all.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        const bool begins = at == 0 || !is_word(all[at - 1]);
        if (begins && (end == all.size() || !is_word(all[end]))) { return place_in(text, at); }
    }
    return text.where;
}

std::string_view Builder::unknown_call(const Text& text) {
    const std::string_view all = text.text;
    for (std::size_t open = all.find('('); open != std::string_view::npos;
         open = all.find('(', open + 1)) {
        std::size_t begin = open;
        while (begin != 0 && is_word(all[begin - 1])) {
            --begin;
        }
        const std::string_view word = all.substr(begin, open - begin);
        const bool name = !word.empty() && (word[0] < '0' || word[0] > '9');
        if (name && !is_function(word)) { return word; }
    }
    return {};
}

void Builder::report_unknown_call(const Text& text, std::string_view name) {
    diagnostics_.error("script-meaning", place_of(text, name),
                       "there is no function \"" + std::string(name) + "\"" +
                           suggestion(name, function_names()));
}

std::optional<Syntax> Builder::parse(const Text& text, Dialect dialect, SyntaxMode mode) {
    ParseError wrong;
    std::optional<Syntax> syntax = parse_expression(text.text, dialect, mode, wrong);
    if (syntax) { return syntax; }
    const std::string_view call = dialect == Dialect::tree ? unknown_call(text) : "";
    if (!call.empty()) {
        report_unknown_call(text, call);
    } else {
        diagnostics_.error("script-syntax", place_in(text, wrong.offset), wrong.message);
    }
    return {};
}

CodeId Builder::checked(const Text& text, CodeId code, const std::vector<EmitError>& errors) {
    for (const EmitError& error : errors) {
        diagnostics_.error("script-meaning", place_in(text, error.offset), error.message);
    }
    return code;
}

CodeId Builder::expression(const Text& text, Dialect dialect, SyntaxMode mode, Names& names) {
    const std::optional<Syntax> syntax = parse(text, dialect, mode);
    if (!syntax) { return {}; }
    std::vector<EmitError> errors;
    const CodeId code = emit(*syntax, names, program.code, errors);
    return checked(text, code, errors);
}

CodeId Builder::store(const Text& text, Names& names) {
    const std::optional<Syntax> location = parse(text, Dialect::machine, SyntaxMode::location);
    if (!location) { return {}; }
    std::vector<EmitError> errors;
    const CodeId code = emit_store(*location, names, program.code, errors);
    return checked(text, code, errors);
}

CodeId Builder::constant(Value value, Dialect dialect) {
    CodeTable& code = program.code;
    if (code.constants.empty()) { code.constants.emplace_back(); }  // see no_operand
    const Operand operand(Space::constant, static_cast<std::uint32_t>(code.constants.size()));
    code.constants.push_back(std::move(value));
    return add_copy(operand, dialect);
}

CodeId Builder::variable(SlotId slot, Dialect dialect) {
    return add_copy(Operand(Space::slot, slot.index), dialect);
}

CodeId Builder::add_copy(Operand operand, Dialect dialect) {
    CodeTable& code = program.code;
    const CodeId id{static_cast<std::uint32_t>(code.instructions.size())};
    code.instructions.push_back({.op = CodeOp::copy,
                                 .last = true,
                                 .tree = dialect == Dialect::tree,
                                 .a = operand,
                                 .b = {}});
    code.offsets.push_back(0);
    code.temporaries = std::max(code.temporaries, 1U);
    return id;
}

// Leaves ------------------------------------------------------------------------------------------

std::uint32_t Builder::add_call(const LeafType& type) {
    LeafCall call{.type = &type};
    std::vector<std::byte>& bytes = program.prototypes;
    call.prototype =
        (static_cast<std::uint32_t>(bytes.size()) + type.align - 1) / type.align * type.align;
    bytes.resize(call.prototype + type.size);
    // the table is aligned as strictly as any leaf; the gaps between members stay zero
    type.construct(bytes.data() + call.prototype);
    call.fresh_size = type.ports.empty() && type.state.empty() ? 0 : type.size;
    call.first_input = static_cast<std::uint32_t>(program.live_inputs.size());
    call.first_output = static_cast<std::uint32_t>(program.bound_outputs.size());
    if (type.host_tag != nullptr) { program.host = &registry_.host(); }
    program.calls.push_back(call);
    return static_cast<std::uint32_t>(program.calls.size() - 1);
}

bool Builder::set_literal(const Port& port, Value value) {
    // texts and untyped values are pointed to, so they live in the constants of the code
    if (port.type == PortType::text || port.type == PortType::any) {
        set_live(port, constant(std::move(value), Dialect::machine));
        return true;
    }
    return write_literal(port, value);
}

bool Builder::set_literal(const Port& port, std::string_view text) {
    if (const std::int64_t* number = enumerator(text); number != nullptr) {
        return set_literal(port, Value::integer(*number));
    }
    if (port.type == PortType::text || port.type == PortType::any) {
        return set_literal(port, Value::text(text));
    }
    literal_.set_text(text);
    return write_literal(port, literal_);
}

bool Builder::write_literal(const Port& port, Value& value) {
    std::byte* self = program.prototypes.data() + program.calls.back().prototype;
    if (!store_input(port, value, self)) { return false; }
    if (port.present != Port::always) {
        const bool present = true;
        std::memcpy(self + port.present, &present, sizeof present);
    }
    return true;
}

void Builder::set_live(const Port& port, CodeId code) {
    const bool always = port.present == Port::always;
    const bool plain_real = port.type == PortType::real && always;
    const bool held_by_value = port.type != PortType::text && port.type != PortType::any && always;
    program.live_inputs.push_back({port_index(port), code,
                                   plain_real ? find_formula(program, code) : FormulaId(),
                                   port.offset, held_by_value && is_steady(program.code, code)});
    ++program.calls.back().input_count;
}

void Builder::set_output(const Port& port, SlotId slot) {
    program.bound_outputs.push_back({port_index(port), slot});
    ++program.calls.back().output_count;
}

std::uint32_t Builder::port_index(const Port& port) const {
    return static_cast<std::uint32_t>(&port - program.calls.back().type->ports.data());
}

// Values of attributes ----------------------------------------------------------------------------

std::string_view pointer_key(std::string_view value, std::string_view port) {
    std::string_view key = trimmed(value);
    key = trimmed(key.substr(1, key.size() - 2));
    return key == "=" ? port : key;
}

Value literal_value(std::string_view value) {
    std::int64_t integer = 0;
    const char* last = value.data() + value.size();
    if (const auto [end, error] = std::from_chars(value.data(), last, integer);
        error == std::errc() && end == last) {
        return Value::integer(integer);
    }
    const ParsedNumber real = parse_number(value);
    if (real.length == value.size() && !value.empty()) { return Value::real(real.value); }
    return Value::text(value);
}

}  // namespace trellis
