#define BOOST_TEST_MODULE rolling_contact
#include <boost/test/unit_test.hpp>
