# Run by CTest: gives the tests that furnas_discover() put into a list "<room>_reliability" their second label,
# which gtest_discover_tests() cannot, because it takes the list of labels apart.
foreach(room engine io viz cases)
  foreach(test IN LISTS ${room}_reliability)
    set_tests_properties(${test} PROPERTIES LABELS "commit;reliability")
  endforeach()
endforeach()
