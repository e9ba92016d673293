#include <grader/tests/support/FitsSchema.h>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <fstream>

namespace ticker::tests {

bool fitsSchema(const std::string& text, const std::string& name) {
    std::ifstream stream{std::string{TICKER_SOURCE_DIR "/docs/schema/"} + name + ".schema.json"};
    const nlohmann::json schemaDocument = nlohmann::json::parse(stream);
    valijson::Schema schema;
    valijson::SchemaParser{}.populateSchema(valijson::adapters::NlohmannJsonAdapter{schemaDocument},
                                            schema);
    const nlohmann::json document = nlohmann::json::parse(text);
    const valijson::adapters::NlohmannJsonAdapter target{document};
    return valijson::Validator{}.validate(schema, target, nullptr);
}

}  // namespace ticker::tests
