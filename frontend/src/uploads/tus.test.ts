import { expect, test } from 'vitest'

import { uploadIdOf } from './tus'

test.each([
  ['http://127.0.0.1:8000/v1/uploads/0193-a', '0193-a'],
  ['/v1/uploads/0193-a/?x=1', '0193-a'],
  [null, ''],
])('the id in %s is %s', (url, id) => {
  expect(uploadIdOf(url)).toBe(id)
})
